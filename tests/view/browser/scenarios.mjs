// SPDX-License-Identifier: MIT
// What a person does with `bedmix view`, done in a real browser. Screenshots stay in $OUT.
import assert from "node:assert/strict";
import http from "node:http";
import {after, before, test} from "node:test";

import {Client, upgradeHeaders} from "./client.mjs";
import {View, bedHeight, fingerprint, launch, open, run, said, screenshot, settle, sliders, stats, until} from "./helpers.mjs";

let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

/** With a view and its page, which are closed whatever happens. */
async function withView(args, options, use) {
  const view = await View.start(...args);
  let page;
  try {
    page = await open(browser, view.url, options);
    await use(page, view);
    assert.deepEqual(page.problems, []);
    await page.context().close();
  } catch (error) {
    if (page) await screenshot(page, "failed");
    throw error;
  } finally {
    await view.stop();
  }
}

const panelWidth = 330;
const bed = {left: 0, top: 0, width: 1280 - panelWidth, height: 720};
const panel = {left: 1280 - panelWidth, top: 0, width: panelWidth, height: 720};
// Ends of a slider's frame.
const [lowEnd, highEnd] = [1280 - panelWidth + 8, 1280 - 22];

/** Where the grab of the panel's slider of this number is, from the top: after that of the speed, those of the inlets. */
const grabOf = async (page, number) => (await sliders(page, panel))[number]?.grab;

/** Drags a slider to a place, which its grab reaches but for the half of its width at the ends. */
async function drag(page, number, x) {
  const slider = await until("a slider", async () => (await sliders(page, panel))[number]);
  await page.mouse.move(slider.grab, slider.y);
  await page.mouse.down();
  await page.mouse.move(x, slider.y, {steps: 6});
  await until("a slider that has followed", async () => Math.abs((await grabOf(page, number)) - x) < 16);
  await page.mouse.up();
  await page.mouse.move(800, 10);  // what explains the slider hides the next
}

/** Waits until the bed is low and does not change any more; its height. */
async function restingHeight(page) {
  let last = await bedHeight(page, bed);
  await until("a bed at rest", async () => {
    await new Promise((done) => setTimeout(done, 500));
    const now = await bedHeight(page, bed), isStill = Math.abs(now - last) < 1;
    last = now;
    return isStill;
  });
  return last;
}

/** Waits until it does. Before a bed is arranged there is nothing to move, and the panel has one line more. */
async function moves(page, part) {
  const before = await fingerprint(page, part);
  await until("a bed that moves", async () => (await fingerprint(page, part)) !== before);
}

test("a live run is watched, steered and paused", () =>
  withView(["tian-2007-even", "--layers", "particles,walls"], {}, async (page) => {
    await moves(page, bed);
    await drag(page, 1, lowEnd);
    await drag(page, 2, lowEnd);
    const low = await restingHeight(page);
    await screenshot(page, "live-low");
    for (const inlet of [1, 2]) await drag(page, inlet, lowEnd + 0.5 * (highEnd - lowEnd));
    await until("a higher bed", async () => (await bedHeight(page, bed)) > 1.3 * low);
    await screenshot(page, "live-high");

    await page.keyboard.press(" ");
    await settle(page);  // it is paused
    await page.keyboard.press(" ");
    await moves(page, bed);
    const {codec, width, height} = await stats(page);
    assert.deepEqual([codec, width, height], ["h264", 1280, 720]);
  }));

test("numbers are typed, on keys and as a phone's keyboard does", () =>
  withView(["tian-2007-even", "--layers", "particles,walls"], {}, async (page) => {
    const edits = () => page.evaluate(() => document.activeElement.id === "typed");
    const edit = async () => {
      const slider = await until("a slider", async () => (await sliders(page, panel))[1]);
      await page.keyboard.down("Control");
      await page.mouse.click(slider.grab, slider.y);
      await page.keyboard.up("Control");
      await until("a field that is edited", edits);
    };
    await moves(page, bed);
    const {grab: start} = await until("a slider", async () => (await sliders(page, panel))[1]);
    await edit();
    await page.keyboard.type("0.59");
    await page.keyboard.press("Backspace");
    await page.keyboard.press("Enter");
    const low = await until("the typed velocity", async () => {
      const grab = await grabOf(page, 1);
      return grab < start - 40 && grab;
    });
    assert.ok(!(await edits()), "the field is left");
    await edit();
    await page.keyboard.insertText("6");
    await page.keyboard.press("Enter");
    await until("the other velocity", async () => (await grabOf(page, 1)) > low + 150);
  }));

test("a recorded run is sought by keys and played", async () => {
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
    await page.keyboard.press(" ");
    await until("a run that is played to its end", async () => (await fingerprint(page, bed)) === end);
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
    const below = {left: 0, top: 440, width: 390, height: 404};
    const larger = 1.25;  // are widgets for a finger
    await until("an upright picture", async () => (await stats(page)).height > (await stats(page)).width);
    await moves(page, {left: 0, top: 0, width: 390, height: 420});
    const speed = await until("the slider of the speed", async () => (await sliders(page, below))[0]);
    await screenshot(page, "phone");
    await page.touchscreen.tap(50, speed.y - 27 * larger);
    await settle(page);  // it is paused
    await screenshot(page, "phone-paused");

    // Right of the text below the slider, where nothing else is.
    const finger = await page.context().newCDPSession(page);
    const touch = (type, ...points) => finger.send("Input.dispatchTouchEvent", {type, touchPoints: points});
    const x = 340, from = speed.y + 23 * larger, way = 100;
    const andSee = async (done) => {
      const {pictures} = await stats(page);
      await done;
      await until("the next picture", async () => (await stats(page)).pictures > pictures);
    };
    await andSee(touch("touchStart", {x, y: from}));
    for (let i = 1; i <= 5; ++i) await andSee(touch("touchMove", {x, y: from - way * i / 5}));
    await touch("touchEnd");
    await until("a panel that is scrolled", async () => {
      const [first] = await sliders(page, below);
      return first && Math.abs(first.y - speed.y) > 5;
    });
    await settle(page);  // still: scrolling is no tap
    await screenshot(page, "phone-scrolled");
  }));

test("JPEG does where the browser has no H.264", () =>
  withView(["tiny"], {}, async (page, view) => {
    const other = await open(browser, `${view.url}#jpeg`);
    await until("pictures", async () => (await stats(other)).pictures > 5);
    assert.equal((await stats(other)).codec, "jpeg");
    assert.equal((await stats(page)).codec, "h264");
    assert.deepEqual(other.problems, []);
    await other.context().close();
  }));

test("what is saved is downloaded", () =>
  withView(["tiny"], {height: 1600}, async (page) => {
    const column = 1280 - panelWidth / 2;
    /** Middles of the panel's headings, which are wider than anything else. */
    const headings = () => page.evaluate(({column, edge}) => {
      const paper = document.getElementById("picture").getContext("2d");
      const {data, height} = paper.getImageData(0, 0, paper.canvas.width, paper.canvas.height);
      const isHeading = (y) => [column, edge].every((x) => {
        const i = 4 * (y * paper.canvas.width + x);
        return Math.abs(data[i] - 38) < 14 && Math.abs(data[i + 1] - 68) < 14 && Math.abs(data[i + 2] - 103) < 18;
      });
      const found = [];
      for (let y = 1, first = 0; y < height; ++y) {
        if (isHeading(y) && !isHeading(y - 1)) first = y;
        if (!isHeading(y) && isHeading(y - 1) && y - first > 15) found.push((first + y) / 2);
      }
      return found;
    }, {column, edge: 1280 - panelWidth + 6});
    await until("the tall window", async () => (await stats(page)).height === 1600);
    await moves(page, bed);
    // Below it there are only those of the solver and of all parameters.
    const save = await until("the headings", async () => (await headings()).at(-3));
    await page.mouse.click(column, save);
    await until("an open section", async () => (await headings()).at(-2) > save + 40);
    // Below the buttons that record: those of the picture and of the scene.
    for (const [x, name] of [[30, /\.png$/], [150, /\.toml$/]]) {
      const coming = page.waitForEvent("download", {timeout: 60000});
      await page.mouse.click(1280 - panelWidth + x, save + 2 * 27);
      assert.match((await coming).suggestedFilename(), name);
    }
    await screenshot(page, "saved");
  }));

test("who looks on cannot steer, and control can be taken", () =>
  withView(["tian-2007-even", "--layers", "particles,walls"], {}, async (page, view) => {
    const looker = await open(browser, view.viewUrl, {width: 700, height: 700});
    assert.equal((await stats(looker)).role, "viewer");
    assert.equal(await said(looker), "You are looking on.");
    assert.equal(await looker.isVisible("#control"), false);
    assert.equal((await stats(looker)).width, 1280, "the picture is the one who steers' own");
    await screenshot(looker, "looking-on");
    await looker.context().close();

    // One that does not keep to what the page does.
    const stranger = await Client.open(view.viewUrl);
    await until("its role", () => stranger.role === "viewer");
    stranger.input({type: "key", key: " ", down: true});
    stranger.input({type: "key", key: " ", down: false});
    stranger.input({type: "size", width: 320, height: 240, scale: 1});
    stranger.send({type: "control"});
    const {pictures} = stranger;
    await until("pictures", () => stranger.pictures > pictures + 10);
    await moves(page, bed);
    assert.deepEqual([stranger.role, (await stats(page)).role, (await stats(page)).width], ["viewer", "controller", 1280]);
    stranger.close();

    const second = await open(browser, view.url, {width: 900, height: 600});
    assert.equal((await stats(second)).role, "viewer");
    await second.focus("#control");
    await second.keyboard.press("Enter");
    await until("the roles changed", async () =>
      (await stats(second)).role === "controller" && (await stats(page)).role === "viewer");
    await until("a picture of its size", async () => (await stats(page)).width === 900);
    await second.context().close();
    await until("control given back", async () => (await stats(page)).role === "controller");
    await until("a picture of the old size", async () => (await stats(page)).width === 1280);
  }));

test("the page says how a view ended, and when it is lost", async () => {
  const view = await View.start("tiny");
  const page = await open(browser, view.url);
  view.child.kill("SIGKILL");
  await until("what is wrong", async () => (await said(page)).includes("trying again"));
  await view.ended;
  const next = await View.start("tiny", "--listen", new URL(view.url).host);
  await until("other secrets", async () => (await said(page)).includes("no longer good"));
  const good = await open(browser, next.url);
  assert.equal(await next.stop(), 130);
  await until("goodbye", async () => (await said(good)) === "the view has ended");
  await screenshot(good, "ended");
  await page.context().close();
  await good.context().close();
});

/** The status of a request, or of an upgrade that is refused. */
function status(url, headers = {}) {
  return new Promise((resolve, reject) => {
    const request = http.get(url, {headers, agent: false}, (answer) => {
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
    const url = new URL(view.url);
    const {Cookie, Origin, ...upgrade} = upgradeHeaders(view.url);
    assert.equal(await status(url.origin), 403, "no token");
    assert.equal(await status(`${url.origin}/?token=${"0".repeat(32)}`), 403, "wrong token");
    assert.equal(await status(url.origin, {Cookie, Host: "evil.example"}), 403, "wrong host");
    assert.equal(await status(`${url.origin}/ws`, {...upgrade, Cookie, Origin: "http://evil.example"}), 403, "wrong origin");
    assert.equal(await status(`${url.origin}/ws`, {...upgrade, Cookie}), 403, "no origin");
    assert.equal(await status(`${url.origin}/ws`, {...upgrade, Origin}), 403, "no cookie");
    assert.equal(await status(`${url.origin}/ws`, {...upgrade, Cookie, Origin}), 101);
  } finally {
    assert.equal(await view.stop(), 130);
  }
});
