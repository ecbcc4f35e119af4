// SPDX-License-Identifier: MIT
// What watching costs and gives, for case A live at 1280 x 720: pictures and bits a second, the time from an
// input to the picture that shows it, and how much the solver is slowed down. Turn by turn; medians of the rounds,
// latencies of all of them together. See view.sh.
import {Client} from "../view/browser/client.mjs";
import {View, launch, open, run, stats, until} from "../view/browser/helpers.mjs";

const rounds = Number(process.env.ROUNDS ?? 3), seconds = Number(process.env.SECONDS_A_TURN ?? 8);
const inputs = 200;  // a turn
const scene = "tian-2007-even";
const size = {width: 1280, height: 720};
const pause = (ms) => new Promise((done) => setTimeout(done, ms));

function quantile(values, share) {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted.length ? sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))] : NaN;
}
const median = (values) => quantile(values, 0.5);

/** Simulated s per wall s, of what a program said last. */
function speedOf(text, pattern) {
  const found = text.match(pattern);
  if (!found) throw new Error(`there is no ${pattern} in:\n${text}`);
  return Number(found[1]) / Number(found[2]);
}
const speedOfView = (view) => speedOf(view.err, /simulated ([\d.e+-]+) s in ([\d.e+-]+) s/);

/** `point` moves the pointer, `click` presses and releases: spread in time, in the panel's empty ground, as what they
 *  do must not change what is measured. The wall time, s. */
async function spread(point, click) {
  const start = performance.now();
  for (let k = 0; k < inputs; ++k) {
    const x = 1160 + (7 * k) % 80, y = 103;
    await (k % 5 === 4 ? click(x, y) : point(x, y));
    await pause((1000 * seconds) / inputs * 2 * Math.random());
  }
  return (performance.now() - start) / 1000;
}

/** A client that decodes nothing and acknowledges at once: what the server and the sockets cost. */
async function plain(codec) {
  const view = await View.start(scene), client = await Client.open(view.url, codec);
  const point = (x, y, buttons = 0) => client.input({type: "pointer", x, y, buttons, touch: false});
  await until("control", () => client.role === "controller");
  client.input({type: "size", ...size, scale: 1});
  await until("pictures", () => client.pictures > 20);
  client.resetStats();
  const wall = await spread(point, (x, y) => {
    point(x, y, 1);
    point(x, y, 0);
  });
  const {pictures, bytes, latencies} = client;
  if (client.codec !== codec) throw new Error(`pictures came as ${client.codec}, not ${codec}`);
  await view.stop();
  client.close();
  return {pictures: pictures / wall, bits: 8e-6 * bytes / wall, latencies, speed: speedOfView(view)};
}

async function browser(codec) {
  const chromium = await launch(), view = await View.start(scene);
  const page = await open(chromium, codec === "jpeg" ? `${view.url}#jpeg` : view.url, size);
  await until("pictures", async () => (await stats(page)).pictures > 20);
  await page.evaluate(() => window.bedmixStats.reset());
  const wall = await spread((x, y) => page.mouse.move(x, y), (x, y) => page.mouse.click(x, y));
  const {pictures, bytes, latencies, codec: used} = await stats(page);
  if (used !== codec) throw new Error(`pictures came as ${used}, not ${codec}`);
  await view.stop();
  await chromium.close();
  return {pictures: pictures / wall, bits: 8e-6 * bytes / wall, latencies, speed: speedOfView(view)};
}

async function alone() {
  const view = await View.start(scene);
  await pause(1000 * (seconds + 2));
  await view.stop();
  return {speed: speedOfView(view)};
}

async function headless() {
  const said = await run("run", scene, "-o", "bench", "--force", "--until", "3", "--threads", "1");
  return {speed: speedOf(said, /done: ([\d.e+-]+) simulated s in ([\d.e+-]+) s/)};
}

const cases = {
  "bedmix run": headless,
  "view, nobody looks": alone,
  "no browser, h264": () => plain("h264"),
  "no browser, jpeg": () => plain("jpeg"),
  "Chromium, h264": () => browser("h264"),
  "Chromium, jpeg": () => browser("jpeg"),
};
const results = Object.fromEntries(Object.keys(cases).map((name) => [name, []]));
for (let round = 0; round < rounds; ++round)
  for (const [name, measure] of Object.entries(cases)) results[name].push(await measure());

const fastest = median(results["bedmix run"].map((r) => r.speed));
const header = ["client", "pictures/s", "Mbit/s", "latency median, ms", "95 %, ms", "simulated s / s", "of bedmix run"];
console.log(`| ${header.join(" | ")} |\n|${" --- |".repeat(header.length)}`);
for (const [name, turns] of Object.entries(results)) {
  const middle = (key, digits) => key in turns[0] ? median(turns.map((turn) => turn[key])).toFixed(digits) : "";
  const latencies = turns.flatMap((turn) => turn.latencies ?? []);
  const late = (share) => latencies.length ? quantile(latencies, share).toFixed(0) : "";
  const speed = median(turns.map((turn) => turn.speed));
  console.log(`| ${[name, middle("pictures", 1), middle("bits", 1), late(0.5), late(0.95), speed.toFixed(3),
                    `${(100 * speed / fastest).toFixed(0)} %`].join(" | ")} |`);
}
