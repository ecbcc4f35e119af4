// SPDX-License-Identifier: MIT
// What watching costs and gives, for case A live at 1280 x 720: pictures and bytes a second, the time from an
// input to the picture that shows it, and how much the solver is slowed down. See view.sh.
import http from "node:http";
import {randomBytes} from "node:crypto";

import {View, launch, open, run, stats} from "../view/browser/helpers.mjs";

const seconds = 8, inputs = 100;
const scene = "tian-2007-even";
const pause = (ms) => new Promise((done) => setTimeout(done, ms));

function quantile(values, share) {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted.length ? sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))] : NaN;
}

/** Simulated s per wall s, of what the view said last. */
function speedOf(view) {
  const [, simulated, wall] = view.err.match(/simulated ([\d.e-]+) s in ([\d.e-]+) s/);
  return Number(simulated) / Number(wall);
}

/** A page that decodes nothing: takes pictures and acknowledges them, by hand, as a WebSocket client without a browser. */
class Taker {
  constructor(view, codec) {
    const url = new URL(view.url);
    this.pictures = this.bytes = this.inputs = 0;
    this.latencies = [];
    this.sent = [];
    this.buffer = Buffer.alloc(0);
    this.ready = new Promise((resolve, reject) => {
      const request = http.get(`${url.origin}/ws`, {headers: {
        Connection: "Upgrade", Upgrade: "websocket", "Sec-WebSocket-Version": "13",
        "Sec-WebSocket-Key": randomBytes(16).toString("base64"), Origin: url.origin,
        Cookie: `bedmix-${url.port}=${url.searchParams.get("token")}`}});
      request.on("upgrade", (_, socket) => {
        this.socket = socket;
        socket.on("data", (data) => this.take(data));
        this.send({type: "hello", codec});
        resolve();
      });
      request.on("response", (answer) => reject(new Error(`refused: ${answer.statusCode}`)));
    });
  }
  send(message) {
    const text = Buffer.from(JSON.stringify(message)), mask = randomBytes(4);
    const head = text.length < 126 ? Buffer.from([0x81, 0x80 | text.length])
                                   : Buffer.from([0x81, 0xfe, text.length >> 8, text.length & 255]);
    this.socket.write(Buffer.concat([head, mask, text.map((byte, i) => byte ^ mask[i % 4])]));
  }
  input(message) {
    this.sent.push({n: ++this.inputs, at: performance.now()});
    this.send({...message, n: this.inputs});
  }
  take(data) {
    this.buffer = Buffer.concat([this.buffer, data]);
    for (;;) {
      if (this.buffer.length < 2) return;
      let length = this.buffer[1] & 127, start = 2;
      if (length === 126) [length, start] = [this.buffer.length < 4 ? Infinity : this.buffer.readUInt16BE(2), 4];
      else if (length === 127) [length, start] = [this.buffer.length < 10 ? Infinity : Number(this.buffer.readBigUInt64BE(2)), 10];
      if (this.buffer.length < start + length) return;
      const opcode = this.buffer[0] & 15, message = this.buffer.subarray(start, start + length);
      this.buffer = this.buffer.subarray(start + length);
      if (opcode === 2) this.show(message);
    }
  }
  show(message) {
    this.bytes += message.length;
    if (message[0] === 4) return;
    this.pictures += 1;
    const input = message.readUInt32LE(8), now = performance.now();
    while (this.sent.length && this.sent[0].n <= input) this.latencies.push(now - this.sent.shift().at);
    this.send({type: "ack", picture: message.readUInt32LE(4)});
  }
}

const rows = [];
function note(name, pictures, bytes, wall, latencies, speed) {
  rows.push({client: name, "pictures/s": (pictures / wall).toFixed(1), "Mbit/s": (8e-6 * bytes / wall).toFixed(1),
             "latency median, ms": quantile(latencies, 0.5).toFixed(0), "95 %, ms": quantile(latencies, 0.95).toFixed(0),
             "solver, x real time": speed.toFixed(3)});
}

async function headless() {
  const err = await run("run", scene, "-o", "bench", "--force", "--until", String(seconds * 0.7), "--threads", "1");
  const [, simulated, wall] = err.match(/done: ([\d.e-]+) simulated s in ([\d.e-]+) s/);
  rows.push({client: "bedmix run, no view", "solver, x real time": (simulated / wall).toFixed(3)});
}

async function alone() {
  const view = await View.start(scene);
  await pause(1000 * seconds + 3000);
  await view.stop();
  rows.push({client: "view, nobody looks", "solver, x real time": speedOf(view).toFixed(3)});
}

async function plain(codec) {
  const view = await View.start(scene), taker = new Taker(view, codec);
  await taker.ready;
  taker.input({type: "size", width: 1280, height: 720, scale: 1});
  await pause(3000);  // the bed is arranged
  Object.assign(taker, {pictures: 0, bytes: 0, latencies: [], sent: []});
  const start = performance.now();
  for (let k = 0; k < inputs; ++k) {
    taker.input({type: "pointer", x: 1000 + k, y: 300, buttons: 0, touch: false});
    await pause((1000 * seconds) / inputs * (0.5 + Math.random()));
  }
  const wall = (performance.now() - start) / 1000, {pictures, bytes, latencies} = taker;
  taker.socket.destroy();
  await view.stop();
  note(`no browser, ${codec}`, pictures, bytes, wall, latencies, speedOf(view));
}

async function browser(codec) {
  const chromium = await launch(), view = await View.start(scene);
  const page = await open(chromium, view.url);
  if (codec === "jpeg") {
    await page.evaluate(() => (location.hash = "#jpeg"));
    await page.reload();
  }
  await pause(3000);
  await page.evaluate(() => window.bedmixStats.reset());
  const start = performance.now();
  for (let k = 0; k < inputs; ++k) {
    await page.mouse.move(1000 + k, 300);
    await pause((1000 * seconds) / inputs * (0.5 + Math.random()));
  }
  const wall = (performance.now() - start) / 1000, {pictures, bytes, latencies} = await stats(page);
  await chromium.close();
  await view.stop();
  note(`Chromium, ${codec}`, pictures, bytes, wall, latencies, speedOf(view));
}

await headless();
await alone();
for (const codec of ["h264", "jpeg"]) await plain(codec);
for (const codec of ["h264", "jpeg"]) await browser(codec);
await headless();
console.table(rows);
