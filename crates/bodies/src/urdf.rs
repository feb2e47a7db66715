//! A link of a URDF file: the `<inertial>` element, and the plain solids in `<visual>`.
//!
//! The origin of `<inertial>` is the centre of mass, and its `rpy` turns the axes of the six numbers:
//! <https://wiki.ros.org/urdf/XML/link>.

use crate::document::decimal_comma;
use crate::error::Error;
use crate::file::within;
use crate::model::{BodyModel, nameable};
use crate::question;
use crate::surface::{FARTHEST, Surface, drawable};
use nalgebra::{Matrix3, UnitQuaternion, Vector3};
use roxmltree::{Document, Node};
use std::collections::{BTreeMap, BTreeSet, HashMap, HashSet};
use std::path::Path;
use tumbling::MassProperties;

fn wrong(node: Node<'_, '_>, why: impl std::fmt::Display) -> Error {
    let place = node.document().text_pos_at(node.range().start);
    let line = usize::try_from(place.row).ok();
    Error { line, ..Error::new(why) }.of_field(node.tag_name().name())
}

fn child<'a, 'i>(node: Node<'a, 'i>, name: &str) -> Option<Node<'a, 'i>> {
    node.children().find(|child| child.has_tag_name(name))
}

fn called<'a>(link: Node<'a, '_>) -> &'a str {
    link.attribute("name").unwrap_or_default()
}

/// The numbers of an attribute.
fn numbers<const N: usize>(node: Node<'_, '_>, name: &str) -> Result<Option<[f64; N]>, Error> {
    let Some(text) = node.attribute(name) else { return Ok(None) };
    let finite = |word: &str| word.parse().ok().filter(|x: &f64| x.is_finite());
    let found: Option<Vec<f64>> = text.split_whitespace().map(finite).collect();
    let found = found.and_then(|found| <[f64; N]>::try_from(found).ok());
    let plural = if N == 1 { "" } else { "s" };
    found.map(Some).ok_or_else(|| {
        // In XML, even a single number has quotes.
        let hint = decimal_comma(node.document().input_text(), node.range().start).replace(", unquoted", "");
        let rule = "expected, in m, kg and rad, without a unit, without the ${} of xacro";
        wrong(node, format!("{name}=\"{text}\": {N} finite number{plural} {rule}{hint}"))
    })
}

fn needed<const N: usize>(node: Node<'_, '_>, name: &str) -> Result<[f64; N], Error> {
    numbers(node, name)?.ok_or_else(|| wrong(node, format!("the attribute `{name}` is missing")))
}

/// How deep elements may be nested: the parser calls itself for each.
const DEEPEST: usize = 200;

/// How many attributes an element, and namespaces a file, may have: the parser compares each with all before.
const MOST: usize = 200;

/// Refuses text that would overflow the parser's stack or take it minutes. In text that the parser accepts,
/// tags and quotes are as this scan sees them; the parser stops at the first that is not.
fn bounded(text: &str) -> Result<(), Error> {
    let refused = |count: usize, of: &str, most: usize| {
        Err(Error::new(format!("{count} {of}: at most {most} are read")))
    };
    let namespaces = text.matches("xmlns").count();
    if namespaces > MOST {
        return refused(namespaces, "namespaces", MOST);
    }
    let (mut depth, mut deepest, mut rest) = (0_usize, 0, text);
    while let Some(start) = rest.find('<') {
        rest = &rest[start..];
        let skipped = [("<!--", "-->"), ("<![CDATA[", "]]>"), ("<?", "?>"), ("</", ">"), ("<!", ">")];
        if let Some((open, close)) = skipped.into_iter().find(|(open, _)| rest.starts_with(open)) {
            depth = depth.saturating_sub(usize::from(open == "</"));
            let body = &rest[open.len()..];
            rest = body.find(close).map_or("", |end| &body[end + close.len()..]);
            continue;
        }
        let (mut quote, mut attributes, mut before) = (None, 0, ' ');
        let end = rest.char_indices().find(|&(_, c)| {
            match quote {
                Some(open) if open == c => quote = None,
                None if c == '"' || c == '\'' => (quote, attributes) = (Some(c), attributes + 1),
                None if c == '>' => return true,
                _ => {}
            }
            before = c;
            false
        });
        if attributes > MOST {
            return refused(attributes, "attributes of one element", MOST);
        }
        depth += usize::from(before != '/');
        deepest = deepest.max(depth);
        rest = end.map_or("", |(end, _)| &rest[end + 1..]);
    }
    if deepest > DEEPEST { refused(deepest, "elements, one in the other", DEEPEST) } else { Ok(()) }
}

/// Where an element lies in the link's frame, and how it is turned.
fn origin(node: Node<'_, '_>) -> Result<(Vector3<f64>, UnitQuaternion<f64>), Error> {
    let Some(origin) = child(node, "origin") else { return Ok(Default::default()) };
    if let Some(other) = origin.attributes().find(|it| !["xyz", "rpy"].contains(&it.name())) {
        return Err(wrong(origin, format!("`{}` is not read, only `xyz` and `rpy`", other.name())));
    }
    let (place, turn) = (numbers::<3>(origin, "xyz")?, numbers(origin, "rpy")?);
    let [roll, pitch, yaw] = turn.unwrap_or_default();
    Ok((place.unwrap_or_default().into(), UnitQuaternion::from_euler_angles(roll, pitch, yaw)))
}

/// Refuses what would change the body and is not read: second elements, and unknown ones in `<inertial>`.
fn alone(link: Node<'_, '_>, inertial: Node<'_, '_>) -> Result<(), Error> {
    let known = ["inertial", "origin", "mass", "inertia"];
    for name in known {
        let here = [link, inertial].into_iter().flat_map(|node| node.children());
        if let Some(second) = here.filter(|child| child.has_tag_name(name)).nth(1) {
            return Err(wrong(second, "one alone is expected here"));
        }
    }
    let other = inertial.children().find(|it| it.is_element() && !known.contains(&it.tag_name().name()));
    other.map_or(Ok(()), |other| Err(wrong(other, "it is not read: only origin, mass and inertia are")))
}

/// Whether the angles of a link are meant in degrees: one is more than a turn.
fn degrees(link: Node<'_, '_>) -> Option<String> {
    let more = |word: &str| word.parse().is_ok_and(|angle: f64| angle.abs() > 6.3);
    let mut rpy = link.descendants().filter_map(|node| node.attribute("rpy"));
    let rpy = rpy.find(|rpy| rpy.split_whitespace().any(more))?;
    Some(format!("rpy=\"{rpy}\" rad is more than a turn: is this in degrees?"))
}

/// The boxes, cylinders and spheres of the link.
fn surfaces(link: Node<'_, '_>, inertia: Node<'_, '_>, centre: &Vector3<f64>) -> Result<Vec<Surface>, Error> {
    let mut found = Vec::new();
    for visual in link.children().filter(|node| node.has_tag_name("visual")) {
        let (place, turn) = origin(visual)?;
        let solid = child(visual, "geometry").and_then(|shape| shape.children().find(Node::is_element));
        let Some(solid) = solid else { continue };
        let size = |name: &str| needed(solid, name).map(|[x]| x);
        let surface = match solid.tag_name().name() {
            "box" => Surface::cuboid(&needed::<3>(solid, "size")?.into()),
            "cylinder" => Surface::cylinder(0.0, size("radius")?, size("length")?),
            "sphere" => Surface::ellipsoid(&Vector3::repeat(size("radius")?)),
            _ => continue,
        };
        let below = |text: &str| text.split_whitespace().any(|size| size.starts_with('-'));
        if let Some(size) = solid.attributes().find(|size| below(size.value())) {
            let why = format!("{}=\"{}\": no size may be below zero", size.name(), size.value());
            return Err(wrong(solid, why));
        }
        let reach = surface.reach();
        drawable(reach).map_err(|why| wrong(solid, why))?;
        if (place - centre).amax() > FARTHEST * reach {
            let far = [visual, inertia].into_iter().find_map(|node| child(node, "origin"));
            return Err(wrong(far.unwrap_or(solid), "so far away that rounding would change its shape"));
        }
        found.push(surface.mapped(|p| turn * p + place));
    }
    Ok(found)
}

/// At most this many names, in backticks.
fn first(names: &[&str], most: usize) -> String {
    let shown: Vec<_> = names.iter().take(most).map(|name| format!("`{name}`")).collect();
    let more = names.len().saturating_sub(most);
    shown.join(", ") + &if more == 0 { String::new() } else { format!(" and {more} more") }
}

/// The links with inertia that fixed joints attach to this one, above or below it.
fn held(document: &Document<'_>, name: &str, heavy: &[&str]) -> Vec<String> {
    let mut near: HashMap<&str, Vec<&str>> = HashMap::new();
    let fixed = |node: &Node<'_, '_>| node.has_tag_name("joint") && node.attribute("type") == Some("fixed");
    for joint in document.descendants().filter(fixed) {
        let [one, other] = ["parent", "child"].map(|end| child(joint, end)?.attribute("link"));
        near.entry(one.unwrap_or_default()).or_default().extend(other);
        near.entry(other.unwrap_or_default()).or_default().extend(one);
    }
    // Each link's joints are taken once, so that a circle of joints ends.
    let (mut open, mut found) = (vec![name], HashSet::new());
    while let Some(links) = open.pop().map(|link| near.remove(link).unwrap_or_default()) {
        found.extend(links.iter().copied());
        open.extend(links);
    }
    heavy.iter().filter(|link| **link != name && found.contains(**link)).map(ToString::to_string).collect()
}

/// The body, with a question if fixed joints attach further links to its own that it has less often: do they
/// belong to it? Some simulators merge such links into one body, others do not.
pub(crate) fn asked(mut model: BodyModel) -> BodyModel {
    let has = |link| model.links.get(link).map_or(0, |(count, _)| *count);
    let held = model.links.values().flat_map(|(count, held)| held.iter().filter(|link| has(*link) < *count));
    let left: Vec<_> = held.collect::<BTreeSet<_>>().into_iter().map(|(_, name)| name.as_str()).collect();
    let rest = "is it one body with them? Then name each in a `[[part]]`, by `urdf`, `link`, `at` and `turn`";
    let words = format!("without {}, which fixed joints hold to it: {rest}", first(&left, 3));
    model.question = model.question.or(Some(words).filter(|_| !left.is_empty()));
    model
}

/// The link `name`, or the only one that has inertia, of the robot in this file. Its tensor may be moved by
/// `tolerance`.
pub(crate) fn read(xml: &str, name: Option<&str>, file: &Path, tolerance: f64) -> Result<BodyModel, Error> {
    bounded(xml)?;
    let document = Document::parse(xml)
        .map_err(|error| Error { line: usize::try_from(error.pos().row).ok(), ..Error::new(error) })?;
    let of_xacro = |node: &Node<'_, '_>| node.tag_name().namespace().is_some_and(|of| of.contains("xacro"));
    if let Some(left) = document.descendants().find(of_xacro) {
        return Err(wrong(left, "an element of xacro: run xacro first, and read the file that it writes"));
    }
    let root = document.root_element();
    if !["robot", "link"].contains(&root.tag_name().name()) {
        let why = "URDF begins with `<robot>`; give others in TOML, by `mass`, `moments` and `products`";
        return Err(wrong(root, why));
    }
    let named = |node: &Node<'_, '_>| node.has_tag_name("link") && node.has_attribute("name");
    let links: Vec<_> = document.descendants().filter(named).collect();
    let heavy: Vec<_> = links.iter().copied().filter(|&link| child(link, "inertial").is_some()).collect();
    let names: Vec<_> = heavy.iter().copied().map(called).collect();
    let all = first(&names, 20);
    let named = |name: &str| links.iter().copied().filter(|link| called(*link) == name).collect();
    let meant: Vec<_> = name.map_or_else(|| heavy.clone(), named);
    let link = match (meant.as_slice(), name) {
        ([only], _) => *only,
        ([], Some(name)) => {
            let why = format!("no link is called `{name}`; those with inertia are {all}");
            return Err(Error::new(why).of_field("link"));
        }
        ([_, again, ..], Some(_)) => return Err(wrong(*again, "another link has this name too")),
        ([], None) => return Err(Error::new("no link with a `name` has an `<inertial>` element")),
        _ => return Err(Error::new(format!("name the link, after a `#` or by `link`: {all}"))),
    };
    let inertial = child(link, "inertial").ok_or_else(|| wrong(link, "it has no `<inertial>` element"))?;
    alone(link, inertial)?;
    let part = |name| child(inertial, name).ok_or_else(|| wrong(inertial, format!("`<{name}>` is missing")));
    let (mass, tensor) = (part("mass")?, part("inertia")?);
    let of = |name: &str| needed(tensor, name).map(|[x]| x);
    let (xx, xy, xz, yy, yz, zz) = (of("ixx")?, of("ixy")?, of("ixz")?, of("iyy")?, of("iyz")?, of("izz")?);
    let matrix = Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
    let (centre, turn) = origin(inertial)?;
    let found = within(matrix, Some(tolerance).filter(|tolerance| *tolerance > 0.0));
    let (inertia, moved) = found.map_err(|error| wrong(tensor, error))?;
    let inertia = inertia.turned(turn).map_err(|error| wrong(tensor, error))?;
    let [weight] = needed(mass, "value")?;
    let properties = MassProperties::new(weight, &centre, inertia).map_err(|error| wrong(mass, error))?;
    let surfaces = surfaces(link, inertial, &centre)?;
    let name = nameable(called(link)).map_err(|why| wrong(link, why))?.to_owned();
    let model = BodyModel { name, moved, ..BodyModel::of(properties, surfaces) };
    let file = file.canonicalize().unwrap_or_else(|_| file.to_owned());
    let held = held(&document, &model.name, &names).into_iter().map(|other| (file.clone(), other)).collect();
    let links = BTreeMap::from([((file, model.name.clone()), (1, held))]);
    let question = degrees(link).or_else(|| question::spread(&model));
    let model = BodyModel { question, links, ..model };
    model.drawable().map_err(|why| wrong(tensor, why))?;
    Ok(model)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str, name: Option<&str>, tolerance: f64) -> Result<BodyModel, Error> {
        super::read(text, name, Path::new(""), tolerance)
    }

    const ARM: &str = "<robot name='r'>\n<link name='world'/>\n<link name='arm'>\n<inertial>\n\
        <origin xyz='0.1 0.2 0.3' rpy='0 0 1.5707963267948966'/>\n<mass value='2'/>\n\
        <inertia ixx='0.02' ixy='0.001' ixz='0' iyy='0.03' iyz='0' izz='0.04'/>\n</inertial>\n\
        <visual><geometry><box size='0.2 0.3 0.4'/></geometry></visual></link>\n</robot>";

    #[test]
    fn a_quarter_turn_of_the_inertial_frame_exchanges_the_moments_across_it() {
        let arm = read(ARM, None, 0.0).unwrap();
        let turned = Matrix3::new(0.03, -0.001, 0.0, -0.001, 0.02, 0.0, 0.0, 0.0, 0.04);
        assert!((arm.inertia.matrix() - turned).amax() < 1e-17);
        assert_eq!((arm.centre, arm.mass), (Vector3::new(0.1, 0.2, 0.3), Some(2.0)));
        assert_eq!(arm.surfaces.len(), 1);
    }

    #[test]
    fn roll_pitch_and_yaw_turn_the_tensor_about_the_fixed_axes_in_that_order() {
        let text = ARM
            .replace("0 0 1.5707963267948966", "0.3 -0.7 1.9")
            .replace("ixz='0'", "ixz='-0.002'")
            .replace("iyz='0'", "iyz='0.003'");
        // R T Rᵀ with R = Rz(yaw) Ry(pitch) Rx(roll), computed apart.
        let (xy, xz, yz) = (-0.001_434_614_362_436_823, 0.002_713_912_808_715_325, -0.010_203_923_007_750_93);
        let [xx, yy, zz] = [0.030_149_988_952_210_27, 0.029_261_950_748_379_87, 0.030_588_060_299_409_86];
        let turned = Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
        let found = read(&text, None, 0.0).unwrap().inertia.matrix();
        assert!((found - turned).amax() < 1e-16, "{found}");
    }

    #[test]
    fn what_is_wrong_is_named_with_its_line() {
        for (from, to, line, words) in [
            ("'0.04'", "'0.06'", 7, "the triangle inequality"),
            ("value='2'", "value='-2'", 6, "the mass is -2.0"),
            ("value='2'", "value='2,5'", 6, "without a unit, without the ${} of xacro; write 2.5"),
            ("robot", "sdf", 1, "line 1, `sdf`: URDF begins with `<robot>`; give others in TOML"),
            ("xyz='0.1 0.2 0.3'", "xyz='0,1 0,2 0,3'", 5, "of xacro; write '0.1 0.2 0.3'"),
            ("xyz='0.1 0.2 0.3'", "xyz='1, 0, 0'", 5, "without the ${} of xacro\n"),
            ("xyz='0.1 0.2 0.3'", "xyz='1,0,0'", 5, "without the ${} of xacro\n"),
            ("iyz='0'", "", 7, "`iyz` is missing"),
            ("xyz='0.1 0.2 0.3'", "xyz='0.1 0.2'", 5, "3 finite numbers expected"),
            ("xyz='0.1 0.2 0.3'", "xyz='0.1 inf 0.3'", 5, "`origin`: xyz=\"0.1 inf 0.3\": 3 finite"),
            ("xyz='0.1 0.2 0.3' r", "quat_xyzw='0 0 1 0' r", 5, "`origin`: `quat_xyzw` is not read"),
            ("<origin xyz", "<Origin xyz", 5, "`Origin`: it is not read: only origin, mass and inertia are"),
            ("name='r'>", "xmlns:xacro='http://www.ros.org/wiki/xacro'><xacro:arm/>", 1, "run xacro first"),
            ("<mass", "<mass value='1'/>\n<mass", 7, "`mass`: one alone is expected"),
            ("</robot>", "<link name='arm'/></robot>", 10, "`link`: another link has this name too"),
            ("size='0.2 0.3 0.4'", "size='0.2 -0.3 0.4'", 9, "`box`: size=\"0.2 -0.3 0.4\": no size may be"),
            ("size='0.2 0.3 0.4'", "size='1e308 1e308 1e308'", 9, "drawn is from 1e-100 m to 1e100 m"),
            ("size='0.2 0.3 0.4'", "size='0 0 0'", 9, "drawn is from"),
            ("<visual>", "<visual>\n<origin xyz='1e300 0 0'/>", 10, "so far away"),
            ("xyz='0.1 0.2 0.3'", "xyz='0.1 1e300 0.3'", 5, "so far away"),
            ("</link>\n</robot>", "\n<visual><origin xyz=''/></visual></link></robot>", 10, "3 finite"),
        ] {
            let error = read(&ARM.replace(from, to), Some("arm"), 0.0).unwrap_err();
            assert_eq!(error.line, Some(line), "{error}");
            assert!(format!("{error}\n").contains(words), "{error}");
        }
        assert!(read(ARM, Some("leg"), 0.0).unwrap_err().why.contains("`arm`"));
        assert!(read(ARM, Some("world"), 0.0).unwrap_err().why.contains("no `<inertial>`"));
        assert!(read(&ARM.replace("<mass", "<maß"), None, 0.0).is_err());
    }

    /// A ball with the trace 6/5 m R² of 0.09 kg m² and 1000 kg has a radius of 8.66 mm: 3.7e8 kg/m³.
    #[test]
    fn degrees_and_a_mass_moments_or_sizes_that_go_with_no_other_are_questioned() {
        let question = |from, to| read(&ARM.replace(from, to), None, 0.0).unwrap().question;
        assert_eq!(question("0 0 1.5707963267948966", "0 0 -6.283185307179586"), None);
        for (from, to, words) in [
            ("1.5707963267948966", "90", "rpy=\"0 0 90\" rad is more than a turn: is this in degrees?"),
            ("value='2'", "value='1000'", "up to 0.04 kg m²: a ball with these would need 3.7e8"),
            ("value='2'", "value='1e-6'", "0.000001 kg and moments up to 0.04 kg m²: a ball with"),
            ("0.2 0.3 0.4", "200 300 400", "a radius of 0.14 m; the drawing reaches 270 m. Are the"),
        ] {
            assert!(question(from, to).unwrap().contains(words), "{:?}", question(from, to));
        }
    }

    /// A tool of its own mass behind a flange without; a sensor is no joint.
    #[test]
    fn what_a_fixed_joint_holds_and_is_left_out_is_questioned_from_both_sides() {
        let arm = &ARM[ARM.find("<link name='arm'>").unwrap()..ARM.find("</robot>").unwrap()];
        let joint = |kind: &str, from: &str, to: &str| {
            format!("<joint name='{to}' type='{kind}'><parent link='{from}'/><child link='{to}'/></joint>")
        };
        let robot = |ends: &str, name: &str| {
            let links = format!("<link name='flange'/>{arm}{}", arm.replace("'arm'", "'tool'"));
            asked(read(&format!("<robot>{links}{ends}</robot>"), Some(name), 0.0).unwrap()).question
        };
        let line = |kind: &str| joint(kind, "flange", "tool") + &joint("fixed", "arm", "flange");
        for ends in [line("fixed"), line("fixed") + &joint("fixed", "tool", "arm")] {
            for [name, left] in [["arm", "tool"], ["tool", "arm"]] {
                let asked = format!("without `{left}`, which fixed joints hold to it: is it one body");
                assert!(robot(&ends, name).unwrap().starts_with(&asked));
            }
        }
        let sensor = line("fixed").replace("joint", "sensor");
        assert_eq!([line("revolute"), sensor].map(|ends| robot(&ends, "arm")), [None, None]);
    }

    #[test]
    fn what_the_parser_cannot_hold_is_refused_with_its_count() {
        let refused = |text: &str| read(text, None, 0.0).unwrap_err().to_string();
        for depth in [201, 16_000, 100_000] {
            let nested = format!("{}{}", "<a>".repeat(depth), "</a>".repeat(depth));
            let hidden = format!("{}{}", "<a b='/>'><!--</a></a>-->".repeat(depth), "</a>".repeat(depth));
            for text in [nested, hidden, "<a>".repeat(depth)] {
                assert!(refused(&text).starts_with(&format!("{depth} elements, one in the other")));
            }
        }
        let many = |count: usize| (0..count).map(|k| format!(" b{k}='{k}'")).collect::<String>();
        assert!(refused(&format!("<a{}/>", many(50_000))).starts_with("50000 attributes"));
        let spaces: String = (0..300).map(|k| format!(" xmlns:b{k}='{k}'")).collect();
        assert!(refused(&format!("<a{spaces}/>")).starts_with("300 namespaces"));
        let links = (0..100_000).map(|k| format!("<link name='l{k}'><inertial/></link>")).collect::<String>();
        assert!(refused(&format!("<robot>{links}</robot>")).ends_with("`l19` and 99980 more"));
        // As deep and as wide as is read.
        let most = |inner: &str| format!("{}{inner}{}", "<a>".repeat(199), "</a>".repeat(199));
        assert!(refused(&most(&format!("<b{}/>", many(200)))).contains("URDF begins with"));
    }

    #[test]
    fn a_tensor_of_few_digits_is_taken_within_the_tolerance_alone() {
        let flat = ARM.replace("izz='0.04'", "izz='0.05007'");
        assert!(read(&flat, None, 0.0).is_err());
        let arm = read(&flat, None, 1e-2).unwrap();
        assert!(arm.moved > 1e-5 && arm.moved < 1e-2, "{}", arm.moved);
    }
}
