//! A drawing as a PDF of one page.

use crate::drawing::{Drawing, plain};
use crate::error::Error;
use pdf_writer::{Content, Finish as _, Name, Pdf, Rect, Ref, TextStr};
use std::collections::HashMap;
use svg2pdf::ConversionOptions;

/// Points of PDF to the pixel of CSS.
const POINTS: f64 = 72.0 / 96.0;

impl Drawing {
    /// The drawing as a PDF page of its own size, or with this width in pixels at 96 to the inch. Its text
    /// uses embedded fonts, so that it can be searched and copied.
    ///
    /// # Errors
    /// What the converter reports.
    pub fn pdf(&self, width: Option<u32>) -> Result<Vec<u8>, Error> {
        let (drawing, its_root) = svg2pdf::to_chunk(&self.tree, ConversionOptions::default())
            .map_err(|e| Error::new("the PDF", e))?;
        let mut next = Ref::new(1);
        let [catalog, pages, page, content, info] = [(); 5].map(|()| next.bump());
        let mut renumbered = HashMap::new();
        let drawing = drawing.renumber(|old| *renumbered.entry(old).or_insert_with(|| next.bump()));
        let root = renumbered.get(&its_root).copied().ok_or_else(|| Error("the PDF is empty".into()))?;

        let [w, h] = self.size();
        let scale = width.map_or(1.0, |width| f64::from(width) / w) * POINTS;
        let (wide, high) = ((w * scale) as f32, (h * scale) as f32);
        let mut pdf = Pdf::new();
        pdf.catalog(catalog).pages(pages).lang(TextStr("en")).viewer_preferences().display_doc_title(true);
        pdf.pages(pages).kids([page]).count(1);
        let mut sheet = pdf.page(page);
        sheet.media_box(Rect::new(0.0, 0.0, wide, high)).parent(pages).contents(content);
        sheet.resources().x_objects().pair(Name(b"S"), root);
        sheet.finish();
        let mut marks = Content::new();
        marks.transform([wide, 0.0, 0.0, high, 0.0, 0.0]).x_object(Name(b"S"));
        pdf.stream(content, &marks.finish());
        let (title, description) = (plain(&self.title), plain(&self.description));
        pdf.document_info(info).title(TextStr(&title)).subject(TextStr(&description));
        pdf.extend(&drawing);
        Ok(pdf.finish())
    }
}
