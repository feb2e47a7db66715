//! The look of the page.

pub(super) const PAGE: &str = "
@page{size:A4;margin:9mm}
:root{--fig-font:'Tumbling Sans',system-ui,sans-serif;--fig-symbols:'Literata','Tumbling Math',Georgia,serif}
body{margin:0;background:var(--fig-paper);font:16px/1.4 var(--fig-font)}
main{max-width:60rem;margin:0 auto;padding:1rem}
h1{font-size:1.6em;margin:0 0 .3em}
h2{font-size:1.1em;margin:.2em 0 .3em}
p,ul{margin:.3em 0}ul{padding-left:1.2em}
.pair{display:grid;grid-template-columns:1fr 1fr;gap:.6rem 2rem;margin:.6rem 0}
figure{margin:0}figure svg{width:100%;height:auto}
table{border-collapse:collapse;margin:.3em 0;width:100%;font-variant-numeric:tabular-nums}
caption{text-align:left;padding-bottom:.15em}
th{text-align:left;font-weight:500}th[scope=col]{font-weight:600;vertical-align:bottom}
td,th{padding:.1em .6em .1em 0;border-bottom:1px solid var(--fig-faint)}
@media(max-width:44rem){.pair{grid-template-columns:1fr}table{display:block;overflow-x:auto}}
@media print{:root{color-scheme:light}body{font-size:8.4pt;line-height:1.2}main{max-width:none;padding:0;display:flex;flex-direction:column;min-height:276mm}
h1{font-size:15pt}h2{font-size:10pt;margin:0}p,ul{margin:.6mm 0}.pair{grid-template-columns:1fr 1fr;margin:auto 0 0;gap:0 3mm}
td,th{padding:0 .6em 0 0;white-space:nowrap}figure svg{width:94.5mm;max-width:100%}section,figure{break-inside:avoid}}
";
