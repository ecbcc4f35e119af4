// SPDX-License-Identifier: MIT
// What the browser's tests and the benchmark have in common: a view, a browser, and waiting for what comes.
import {spawn} from "node:child_process";
import {mkdirSync} from "node:fs";
import path from "node:path";

export const program = path.resolve(process.env.BEDMIX);
export const folder = path.resolve(process.env.OUT);
const chromium = "/usr/bin/chromium";
const patience = 60000;  // ms, that a condition is waited for

mkdirSync(folder, {recursive: true});

/** Runs bedmix to its end; what it said. */
export function run(...args) {
  return new Promise((resolve, reject) => {
    const child = spawn(program, args, {cwd: folder});
    let err = "";
    child.stderr.on("data", (data) => (err += data));
    child.on("close", (code) => (code === 0 ? resolve(err) : reject(new Error(`bedmix ${args.join(" ")}: ${code}\n${err}`))));
  });
}

/** A running `bedmix view`. */
export class View {
  static start(...args) {
    return new Promise((resolve, reject) => {
      const view = new View();
      view.err = "";
      view.child = spawn(program, ["view", ...args], {cwd: folder});
      view.child.stderr.on("data", (data) => (view.err += data));
      view.ended = new Promise((done) => view.child.on("close", done));
      view.ended.then((code) => reject(new Error(`bedmix view ended: ${code}\n${view.err}`)));
      view.child.stdout.once("data", async (data) => {
        view.url = data.toString().trim();
        await until("the address for viewers", () => view.err.includes("to look on only: "));
        view.viewUrl = view.err.match(/to look on only: (\S+)/)[1];
        resolve(view);
      });
    });
  }
  /** Stops it as Ctrl+C does; its exit code. */
  stop() {
    this.child.kill("SIGTERM");
    return this.ended;
  }
}

/** Waits until `condition` gives something true, and gives that. */
export async function until(what, condition, most = patience) {
  for (const start = Date.now(); Date.now() - start < most;) {
    const value = await condition();
    if (value) return value;
    await new Promise((done) => setTimeout(done, 50));
  }
  throw new Error(`in ${most / 1000} s there was not: ${what}`);
}

export async function launch() {
  const {chromium: browserType} = await import(path.resolve(process.env.PLAYWRIGHT, "node_modules/playwright-core/index.mjs"));
  return browserType.launch({executablePath: chromium, args: ["--no-sandbox", "--disable-gpu"]});
}

/** A page that shows the view, with pictures coming. */
export async function open(browser, url, {width = 1280, height = 720, ...options} = {}) {
  const context = await browser.newContext({viewport: {width, height}, ...options});
  const page = await context.newPage();
  page.problems = [];
  page.on("pageerror", (error) => page.problems.push(String(error)));
  page.on("console", (message) => message.type() === "error" && page.problems.push(message.text()));
  await page.goto(url);
  await until("pictures", async () => (await stats(page)).pictures > 0).catch((error) => {
    throw new Error(`${error.message}; the page says: ${page.problems.join(", ")}`);
  });
  return page;
}

export const stats = (page) => page.evaluate(() => ({...window.bedmixStats}));

/** Pixels of a part of the canvas in CSS pixels, as one number that tells pictures apart. */
export const fingerprint = (page, part) =>
  page.evaluate(({left, top, width, height}) => {
    const canvas = document.getElementById("picture"), scale = canvas.width / window.innerWidth;
    const data = canvas.getContext("2d").getImageData(left * scale, top * scale, width * scale, height * scale).data;
    let hash = 7;
    for (let i = 0; i < data.length; i += 4) hash = (31 * hash + data[i] + 3 * data[i + 1] + 7 * data[i + 2]) | 0;
    return hash;
  }, part);

/** How high above the bed's floor its particles are in the mean, in CSS pixels: of those that are green. */
export const bedHeight = (page, part) =>
  page.evaluate(({left, top, width, height}) => {
    const canvas = document.getElementById("picture"), scale = canvas.width / window.innerWidth;
    const {data, width: columns, height: rows} = canvas.getContext("2d").getImageData(
      left * scale, top * scale, width * scale, height * scale);
    let sum = 0, count = 0, lowest = 0;
    for (let i = 0; i < 4 * columns * rows; i += 4) {
      if (data[i] > 90 || data[i + 1] < 120 || data[i + 2] < 70 || data[i + 2] > 150) continue;
      lowest = Math.floor(i / 4 / columns);
      sum += lowest;
      ++count;
    }
    return count === 0 ? 0 : (lowest - sum / count) / scale;
  }, part);

/** The panel's sliders that are wholly to be seen, from top to bottom, in CSS pixels: each has a grab of a blue of
 *  its own in a frame. `grab` is its middle. */
export const sliders = (page, panel) =>
  page.evaluate(({left, top, width, height}) => {
    const canvas = document.getElementById("picture"), scale = canvas.width / window.innerWidth;
    const {data, width: columns, height: rows} = canvas.getContext("2d").getImageData(
      left * scale, top * scale, width * scale, height * scale);
    const isBlue = (x, y, blue, slack) => {
      const i = 4 * (y * columns + x);
      return blue.every((value, c) => Math.abs(data[i + c] - value) < slack);
    };
    const grabs = [[61, 133, 224], [66, 150, 250]];  // at rest, and under the pointer
    const found = [];
    let above = null;
    for (let y = 0; y < rows; ++y) {
      let first = -1, last = -1;
      for (let x = 0; x < columns; ++x)
        if (grabs.some((grab) => isBlue(x, y, grab, 24))) {
          if (first < 0) first = x;
          last = x;
        }
      const isGrab = last - first >= 8 * scale && last - first < 24 * scale;
      // A check mark is where no frame is beside it.
      const middle = Math.round(columns / 2), beside = first > middle ? Math.round(0.1 * columns) : Math.round(0.9 * columns);
      if (isGrab && !isBlue(beside, y, [28, 32, 38], 10)) {
        above ??= {from: y, grab: (first + last) / 2};
        above.to = y;
      } else if (above && y - above.to > 12 * scale) {  // not just the slider's text over it
        if (above.to - above.from > 8 * scale)
          found.push({y: top + (above.from + above.to) / 2 / scale, grab: left + above.grab / scale});
        above = null;
      }
    }
    return found;
  }, panel);

/** Waits until the view is at rest: the picture is the sharp one, and none has come for a while. */
export async function settle(page, quiet = 700) {
  let last = -1, since = 0;
  await until("a view at rest", async () => {
    const {pictures, isSharp} = await stats(page);
    if (pictures !== last || !isSharp) [last, since] = [pictures, Date.now()];
    return Date.now() - since > quiet;
  });
}

export const screenshot = (page, name) => page.screenshot({path: path.join(folder, `${name}.png`)});

/** What the bar of the page says. */
export const said = (page) => page.evaluate(() => document.getElementById("bar").hidden ? "" : document.getElementById("said").textContent);
