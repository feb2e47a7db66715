// Draws book/chapters/preview.png, the picture that a shared link shows, from the cover's drawing.
// To be run after the cover has changed: npm run preview.

import { chromium } from "playwright-core";
import { readFile } from "node:fs/promises";
import { fileURLToPath } from "node:url";

const root = fileURLToPath(new URL("../../", import.meta.url));
const cover = await readFile(`${root}figures/cover.svg`, "utf8");
const font = await readFile(`${root}book/theme/fonts/literata.woff2`);
const page = `<!DOCTYPE html><meta charset="utf-8"><style>
@font-face { font-family: Literata; src: url(data:font/woff2;base64,${font.toString("base64")}); }
body { margin: 0; width: 1200px; height: 630px; display: flex; align-items: center; background: #fff; color: #1f2328;
       font-family: Literata, serif; }
svg { width: 640px; height: auto; margin-inline: 40px 20px; flex: none; }
h1 { font-size: 92px; font-weight: 600; margin: 0 0 24px; letter-spacing: -0.01em; }
p { font-size: 38px; line-height: 1.35; margin: 0 40px 0 0; }
</style>${cover}<div><h1>Tumbling</h1><p>Why a tossed book flips over, again and again, untouched.</p></div>`;

const browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: ["--no-sandbox"] });
const tab = await browser.newPage({ viewport: { width: 1200, height: 630 }, colorScheme: "light" });
await tab.setContent(page);
await tab.evaluate(() => document.fonts.ready);
await tab.screenshot({ path: `${root}book/chapters/preview.png` });
await browser.close();
