// SPDX-License-Identifier: MIT
// What a person does with `bedmix view`, done in a real browser. Screenshots stay in $OUT.
import assert from "node:assert/strict";
import http from "node:http";
import {after, before, test} from "node:test";

import {View, bedRows, fingerprint, launch, open, run, screenshot, settle, stats, until} from "./helpers.mjs";

let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

/** With a view and its page, which are closed whatever happens. */
async function withView(args, options, use) {
  const view = await View.start(...args);
  try {
    const page = await open(browser, view.url, options);
    await use(page, view);
    assert.deepEqual(page.problems, []);
    await page.context().close();
  } finally {
    await view.stop();
  }
}

const panelWidth = 330;
const bed = {left: 0, top: 0, width: 1280 - panelWidth, height: 720};
const panelX = 1280 - panelWidth / 2;
/** Right of the middle, over the slider of the first inlet at 1280 x 720. */
const inlet = {y: 178, left: 962, right: 1262};

test("a live run is watched, steered and paused", () =>
  withView(["tian-2007-even", "--layers", "particles,walls"],
           {}, async (page) => {
    const first = await fingerprint(page, bed);
    await until("a moving bed", async () => (await fingerprint(page, bed)) !== first);
    await until("both inlets turned down", async () => {
      for (const y of [inlet.y, inlet.y + 46]) {
        await page.mouse.move(inlet.left + 100, y);
        await page.mouse.down();
        await page.mouse.move(inlet.left + 2, y, {steps: 4});
        await page.mouse.up();
      }
      return true;
    });
    await screenshot(page, "live-low");
    let low = await bedRows(page, bed);
    await until("a bed at rest", async () => {
      await new Promise((done) => setTimeout(done, 500));
      const now = await bedRows(page, bed), still = Math.abs(now - low) < 3;
      low = now;
      return still;
    });
    for (const y of [inlet.y, inlet.y + 46]) {
      await page.mouse.move(inlet.left + 2, y);
      await page.mouse.down();
      await page.mouse.move(inlet.left + 150, y, {steps: 8});
      await page.mouse.up();
    }
    await until("a higher bed", async () => (await bedRows(page, bed)) > 1.3 * low);
    await screenshot(page, "live-high");

    await page.keyboard.press(" ");
    await settle(page);
    const paused = await fingerprint(page, bed);
    await new Promise((done) => setTimeout(done, 700));
    assert.equal(await fingerprint(page, bed), paused, "the bed stands still");
    await page.keyboard.press(" ");
    await until("a bed that goes on", async () => (await fingerprint(page, bed)) !== paused);
    const {codec, width, height} = await stats(page);
    assert.deepEqual([codec, width, height], ["h264", 1280, 720]);
  }));

test("a recorded run is sought by keys and slider", async () => {
  await run("run", "tiny", "-o", "recorded", "--force");
  await withView(["recorded", "--layers", "particles,walls"], {}, async (page) => {
    await page.mouse.move(600, 700);
    await page.keyboard.press("Home");
    await settle(page);
    const start = await fingerprint(page, bed);
    await page.keyboard.press("End");
    await until("the end", async () => (await fingerprint(page, bed)) !== start);
    await settle(page);
    const end = await fingerprint(page, bed);
    assert.notEqual(end, start);
    await page.keyboard.press("Home");
    await until("the start again", async () => (await fingerprint(page, bed)) === start);
    await screenshot(page, "recorded");
  });
});

test("the picture follows the window", () =>
  withView(["tiny"], {}, async (page) => {
    await page.setViewportSize({width: 900, height: 600});
    await until("the new size", async () => (await stats(page)).width === 900 && (await stats(page)).height === 600);
    await screenshot(page, "resized");
  }));

test("a phone has the panel below the bed and is worked by a finger", () =>
  withView(["tiny"], {width: 390, height: 844, deviceScaleFactor: 3, isMobile: true, hasTouch: true}, async (page) => {
    await until("an upright picture", async () => (await stats(page)).height > (await stats(page)).width);
    await screenshot(page, "phone");
    const above = {left: 0, top: 0, width: 390, height: 420};
    await page.touchscreen.tap(45, 844 * 0.52 + 42);
    await settle(page);
    const paused = await fingerprint(page, above);
    await new Promise((done) => setTimeout(done, 700));
    assert.equal(await fingerprint(page, above), paused, "the tap has paused it");
    await screenshot(page, "phone-paused");
  }));

test("JPEG does where the browser has no H.264", () =>
  withView(["tiny"], {}, async (page) => {
    await page.evaluate(() => (location.hash = "#jpeg"));
    await page.reload();
    await until("pictures", async () => (await stats(page)).pictures > 5);
    assert.equal((await stats(page)).codec, "jpeg");
  }));

test("who looks on cannot steer, and control can be taken", () =>
  withView(["tian-2007-even", "--layers", "particles,walls"], {}, async (page, view) => {
    const looker = await open(browser, view.viewUrl);
    assert.equal((await stats(looker)).role, "viewer");
    assert.equal(await looker.isVisible("#control"), false);
    await looker.keyboard.press(" ");
    const before = await fingerprint(looker, bed);
    await until("a bed that goes on", async () => (await fingerprint(looker, bed)) !== before);
    const second = await open(browser, view.url);
    await second.click("#control");
    await until("the roles changed", async () =>
      (await stats(second)).role === "controller" && (await stats(page)).role === "viewer");
    await looker.context().close();
    await second.context().close();
  }));

/** The status of a request, or of an upgrade that is refused. */
function status(url, headers = {}) {
  return new Promise((resolve, reject) => {
    const request = http.get(url, {headers}, (answer) => {
      answer.resume();
      resolve(answer.statusCode);
    });
    request.on("upgrade", (_, socket) => {
      socket.destroy();
      resolve(101);
    });
    request.on("error", reject);
  });
}

test("strangers are refused", async () => {
  const view = await View.start("tiny");
  try {
    const url = new URL(view.url), token = url.searchParams.get("token");
    const cookie = `bedmix-${url.port}=${token}`;
    const upgrade = {Connection: "Upgrade", Upgrade: "websocket", "Sec-WebSocket-Version": "13",
                     "Sec-WebSocket-Key": "dGhlIHNhbXBsZSBub25jZQ=="};
    assert.equal(await status(url.origin), 403, "no token");
    assert.equal(await status(`${url.origin}/?token=${"0".repeat(32)}`), 403, "wrong token");
    assert.equal(await status(url.origin, {Cookie: cookie, Host: "evil.example"}), 403, "wrong host");
    assert.equal(await status(`${url.origin}/ws`, {...upgrade, Cookie: cookie, Origin: "http://evil.example"}), 403);
    assert.equal(await status(`${url.origin}/ws`, {...upgrade, Cookie: cookie}), 403, "no origin");
    assert.equal(await status(`${url.origin}/ws`, {...upgrade, Cookie: cookie, Origin: url.origin}), 101);
  } finally {
    assert.equal(await view.stop(), 130);
  }
});
