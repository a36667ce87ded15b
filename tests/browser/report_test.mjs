// report_test.mjs REPORTS OUT - opens every REPORTS/*/report.html in headless Chromium, as a file,
// and checks what a reader would notice; screenshots go to OUT.
// Exit codes: 0 fine, 1 a fault, 77 a skip (no Chromium, or no node_modules here).
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import {pathToFileURL} from "node:url";

const CHROMIUM = "/usr/bin/chromium";
const [reports, out] = process.argv.slice(2);
const WIDTHS = [1280, 480, 320];

function skip(why) {
  console.log(`skipped: ${why}`);
  process.exit(77);
}

if (!fs.existsSync(CHROMIUM)) skip(`${CHROMIUM} is absent (apt-get install chromium)`);
const {chromium} = await import("playwright-core").catch(() =>
  skip("playwright-core is absent (npm ci --ignore-scripts in tests/browser)"));

const faults = [];
function expect(holds, what) {
  if (!holds) faults.push(what);
}

// What a page does that a static, self-contained one must not.
function watch(page) {
  const seen = {errors: [], requests: []};
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type())) seen.errors.push(message.text());
  });
  page.on("pageerror", (error) => seen.errors.push(String(error)));
  page.on("requestfailed", (request) => seen.errors.push(`failed: ${request.url().slice(0, 80)}`));
  page.on("request", (request) => {
    if (!request.url().startsWith("data:")) seen.requests.push(request.url());
  });
  return seen;
}

const undecoded = (page) => page.$$eval("img", async (images) => {
  await Promise.all(images.map((image) => image.decode().catch(() => {})));
  return images.filter((image) => !(image.complete && image.naturalWidth > 0)).length;
});

const overflow = (page) =>
  page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);

// For those who do not see the page: pictures have words, tables have heads and captions.
const unnamed = (page) => page.evaluate(() => {
  const bad = [];
  for (const image of document.images) if (!image.alt.trim()) bad.push("img without alt");
  for (const svg of document.querySelectorAll("svg"))
    if (!svg.getAttribute("aria-label")) bad.push("svg without label");
  for (const table of document.querySelectorAll("table")) {
    if (!table.caption?.textContent.trim()) bad.push("table without caption");
    if (!table.querySelector("thead th[scope=col]")) bad.push("table without column heads");
    for (const row of table.tBodies[0].rows)
      if (!row.querySelector("th[scope=row]")) bad.push("row without head");
    const widths = new Set([...table.rows].map((row) => row.cells.length));
    if (widths.size !== 1) bad.push(`table with rows of ${[...widths]} cells`);
  }
  const ids = [...document.querySelectorAll("[id]")].map((element) => element.id);
  if (new Set(ids).size !== ids.length) bad.push("an id twice");
  return bad;
});

const rowsOf = (page, selector) =>
  page.$$eval(selector, (tables) => tables.map((table) => table.tBodies[0].rows.length));

// Text against its background, WCAG 2.1: 4.5 to 1.
const faint = (page) => page.evaluate(() => {
  const channels = (color) => (color.match(/[\d.]+/g) ?? []).map(Number);
  const light = ([r, g, b]) => {
    const [x, y, z] = [r, g, b].map((v) =>
      v / 255 <= 0.04045 ? v / 255 / 12.92 : ((v / 255 + 0.055) / 1.055) ** 2.4);
    return 0.2126 * x + 0.7152 * y + 0.0722 * z;
  };
  const ground = (element) => {
    for (let e = element; e; e = e.parentElement) {
      const color = channels(getComputedStyle(e).backgroundColor);
      if (color.length === 3 || color[3] > 0) return color;
    }
    return [255, 255, 255];
  };
  const bad = new Set();
  const texts = "p,td,th,dt,dd,b,span,caption,figcaption,summary,text,small,li";
  for (const element of document.querySelectorAll(texts)) {
    const style = getComputedStyle(element);
    const ink = channels(element.tagName === "text" ? style.fill : style.color);
    const [low, high] = [light(ink), light(ground(element))].sort((a, b) => a - b);
    if ((high + 0.05) / (low + 0.05) < 4.5) bad.add(`${element.tagName}.${element.className}`);
  }
  return [...bad];
});

// The whole unit's section: there with everything in it, or with one sentence where the unit is
// built without counters, or not at all.
async function checkUnit(page, name, json, same) {
  const silent = json.unit !== undefined && json.config.unit.counters === false;
  const said = await page.$$eval("p", (all) =>
    all.some((text) => text.textContent.includes("built without counters")));
  expect(said === silent, `${name}: without counters ${silent}, the page says so: ${said}`);
  const unit = silent ? undefined : json.unit;
  await same("table.cycles", unit ? [6] : []);
  const textures = unit?.draws.flatMap((draw) => [draw.texture, draw.color]).filter(Boolean);
  await same("table.textures", unit ? [textures.length] : []);
  await same("table.speed", unit ? [Object.keys(unit.timings).length] : []);
  const bars = await page.$$eval("svg.cycles", (all) => all.map((svg) =>
    [...svg.querySelectorAll("rect")].reduce((sum, part) => sum + part.getBBox().width, 0)));
  const counting = Object.values(unit ? unit.timings : {}).filter((timing) => !timing.estimate);
  expect(bars.length === counting.length, `${name}: bars ${bars}`);
  for (const bar of bars) expect(Math.abs(bar - 1000) < 0.1, `${name}: a bar of ${bar}`);
  const curves = new Set(Object.values(unit?.timings ?? {})
    .map((timing) => String(timing.lines_per_window)).filter(Boolean));
  const drawn = await page.$$eval("figure.rate path:not(.area)", (paths) => paths.length);
  expect(drawn === curves.size, `${name}: ${drawn} curves of bandwidth, not ${curves.size}`);
  const late = (json.unit?.late_pixels ?? 0) + (json.unit?.differing_counters.length ?? 0);
  const verdict = (await page.textContent("header")).includes("differ in time");
  expect(verdict === late > 0, `${name}: late ${late}, the page says so: ${verdict}`);
}

async function checkAgainstJson(page, name, json) {
  const models = Object.keys(json.models);
  const counters = new Set(models.flatMap((model) => Object.keys(json.models[model].counters)));
  const once = (count) => (count > 0 ? [count] : []);
  const same = async (selector, expected) => {
    const found = await rowsOf(page, selector);
    expect(String(found) === String(expected),
      `${name}: ${selector} has ${found} rows, not ${expected}`);
  };
  await same("table.pairs", once(json.differences.length));
  await same("table.presets", once(json.presets.length));
  await same("table.time", [5]);
  await same("table.counters", once(counters.size));
  await same("table.values", json.worst.map((pixel) =>
    3 + new Set(Object.values(pixel.models).flatMap((model) => Object.keys(model.values))).size));
  await checkUnit(page, name, json, same);
  const made = "section[aria-labelledby=made_by]";
  const parameters = Object.values(json.config).flatMap((table) => Object.keys(table));
  const named = await page.$$eval(`${made} dt`, (all) => all.map((term) => term.textContent));
  expect(parameters.every((parameter) => named.includes(parameter)),
    `${name}: the page's parameters are ${named}, not ${parameters}`);
  expect((await page.textContent(made)).includes(json.made_by.commit), `${name}: no commit`);
  const title = await page.textContent("h1");
  expect(title === json.scene.file, `${name}: the heading is ${title}, not ${json.scene.file}`);
  const shown = Math.min(12, json.scene.lights.length);
  const pictures = await page.$$eval("img[alt^='Picture by']", (images) => images.length);
  expect(pictures === shown * models.length, `${name}: ${pictures} pictures`);
  const differs = json.differences.some((pair) => pair.max > 0);
  const heat = await page.$$eval("img[alt^='Heat map']", (images) => images.length);
  expect(heat > 0 === differs, `${name}: ${heat} heat maps, models differ: ${differs}`);
}

async function checkReport(browser, name) {
  const file = path.join(reports, name, "report.html");
  const json = JSON.parse(fs.readFileSync(path.join(reports, name, "report.json"), "utf8"));
  for (const colorScheme of ["light", "dark"]) {
    const page = await browser.newPage({colorScheme, viewport: {width: 1280, height: 900}});
    const seen = watch(page);
    await page.goto(pathToFileURL(file).href, {waitUntil: "load"});
    expect((await undecoded(page)) === 0, `${name}: ${await undecoded(page)} pictures not decoded`);
    expect((await page.$$("script")).length === 0, `${name}: a script`);
    await checkAgainstJson(page, name, json);
    for (const what of await unnamed(page)) expect(false, `${name}: ${what}`);
    for (const what of await faint(page)) expect(false, `${name}, ${colorScheme}: faint ${what}`);
    for (const width of WIDTHS) {
      await page.setViewportSize({width, height: 900});
      const over = await overflow(page);
      expect(over <= 0, `${name}: ${over} pixels too wide at ${width}`);
      const shot = path.join(out, `${name}-${colorScheme}-${width}.png`);
      await page.screenshot({path: shot, fullPage: true});
    }
    for (const error of seen.errors) expect(false, `${name}: ${error}`);
    expect(seen.requests.length === 1, `${name}: requests ${seen.requests}`);
    await page.close();
  }
}

// The checks must be able to fail: a page that does everything wrong.
async function checkTheChecks(browser, folder) {
  const file = path.join(folder, "bad.html");
  fs.writeFileSync(file, `<!DOCTYPE html><title>bad</title><body style="background:#fff">
    <p style="color:#ccc">faint</p><div style="width:3000px">wide</div>
    <img src="data:image/png;base64,AAAA"><img src="missing.png"><svg></svg>
    <table><tbody><tr><td>1</td></tr></tbody></table><script>throw new Error("thrown")</script>`);
  const page = await browser.newPage({viewport: {width: 1280, height: 900}});
  const seen = watch(page);
  await page.goto(pathToFileURL(file).href, {waitUntil: "load"});
  expect((await undecoded(page)) === 2, "self-check: broken pictures pass");
  expect((await overflow(page)) > 0, "self-check: a wide page passes");
  expect((await unnamed(page)).length >= 5, "self-check: unnamed things pass");
  expect((await faint(page)).length > 0, "self-check: faint text passes");
  expect(seen.requests.length === 2, "self-check: a request passes");
  expect(seen.errors.some((error) => error.includes("thrown")), "self-check: an exception passes");
  await page.close();
}

const folder = fs.mkdtempSync(path.join(os.tmpdir(), "ptm-browser-"));
fs.mkdirSync(out, {recursive: true});
// launch() gives every browser a fresh user-data folder of its own.
const browser = await chromium.launch({
  executablePath: CHROMIUM,
  headless: true,
  args: ["--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking",
         "--disable-component-update", "--disable-sync"],
});
const names = fs.readdirSync(reports).filter((name) =>
  fs.existsSync(path.join(reports, name, "report.html")));
expect(names.length >= 6, `found ${names.length} reports, expected six kinds`);
try {
  await checkTheChecks(browser, folder);
  for (const name of names) await checkReport(browser, name);
} finally {
  await browser.close();
  fs.rmSync(folder, {recursive: true, force: true});
}
for (const fault of faults) console.log(fault);
console.log(`${names.length} reports, widths ${WIDTHS}, light and dark: ${faults.length} faults`);
process.exit(faults.length ? 1 : 0);
