// SPDX-License-Identifier: MIT
// The page of `bedmix view`: shows the pictures that come over the WebSocket and sends back what is done to
// them. The messages are described in assets/docs/view.md.
"use strict";

const headerBytes = 16;
const kinds = {jpeg: 1, h264Key: 2, h264Next: 3, notice: 4};
const keys = ["ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown", "PageUp", "PageDown", "Home", "End", "Delete",
              "Backspace", " ", "Enter", "Escape", "Tab", "Shift", "Control", "Alt"];
const mostPixels = 2100000, mostSide = 4096;
const codecOfVideo = "avc1.42C02A";  // constrained baseline, up to 1920 x 1080

const canvas = document.getElementById("picture"), paper = canvas.getContext("2d", {alpha: false});
const typed = document.getElementById("typed");
const bar = document.getElementById("bar"), said = document.getElementById("said");
const control = document.getElementById("control"), keyboard = document.getElementById("keyboard");

// What a test or a benchmark wants to know.
const stats = {
  pictures: 0, bytes: 0, sharp: 0, isSharp: false, codec: "", role: "", width: 0, height: 0, startedAt: performance.now(), latencies: [],
  reset() { Object.assign(this, {pictures: 0, bytes: 0, sharp: 0, startedAt: performance.now(), latencies: []}); },
};
window.bedmixStats = stats;

let socket = null, delay = 250, hasEnded = false;
let inputs = 0;
let sent = [];  // {n, at}: inputs whose effect has not been seen yet

// ---------------------------------------------------------------------------------------------------- sending

const isOpen = () => socket !== null && socket.readyState === WebSocket.OPEN;

function send(message) {
  if (isOpen()) socket.send(JSON.stringify(message));
}

function sendInput(message) {
  if (stats.role !== "controller") return;
  message.n = ++inputs;
  sent.push({n: inputs, at: performance.now()});
  if (sent.length > 1000) sent.shift();
  send(message);
}

// Widgets that a finger has to meet are larger.
const forFinger = window.matchMedia("(pointer: coarse)").matches ? 1.25 : 1;

function sendSize() {
  const width = canvas.clientWidth, height = canvas.clientHeight;
  if (width === 0 || height === 0) return;
  const ratio = Math.min(window.devicePixelRatio || 1, 4, Math.sqrt(mostPixels / (width * height)),
                         mostSide / Math.max(width, height));
  const side = (css) => Math.max(16, 2 * Math.floor(css * ratio / 2));
  sendInput({type: "size", width: side(width), height: side(height),
             scale: Math.min(4, Math.max(0.5, ratio * forFinger))});
}

let resizing = 0;
function onResize() {
  clearTimeout(resizing);
  resizing = setTimeout(sendSize, 100);
}
window.addEventListener("resize", onResize);  // also where the window comes to a finer screen
new ResizeObserver(onResize).observe(canvas);

// ---------------------------------------------------------------------------------------------------- pointer

// Where something happened, in pixels of the picture, which lies in the middle of the canvas.
function placeOf(event) {
  const box = canvas.getBoundingClientRect();
  const ratio = Math.min(box.width / canvas.width, box.height / canvas.height) || 1;
  return {x: (event.clientX - box.left - box.width / 2) / ratio + canvas.width / 2,
          y: (event.clientY - box.top - box.height / 2) / ratio + canvas.height / 2};
}

let buttons = 0;        // as sent last
let moved = null;       // the last move of this animation frame, which shows nothing of buttons
let isFinger = false;   // the pointer that was pressed last

function flushMove() {
  if (moved) sendInput(moved);
  moved = null;
}

function onPointer(event) {
  if (event.pointerType === "touch" && !event.isPrimary) return;
  const message = {type: "pointer", ...placeOf(event), buttons: event.buttons & 7, touch: event.pointerType === "touch"};
  // A second button beside the first comes as a move.
  if (event.type === "pointermove" && message.buttons === buttons) {
    if (!moved) requestAnimationFrame(flushMove);
    moved = message;
    return;
  }
  flushMove();
  buttons = message.buttons;
  sendInput(message);
}

function leave() {
  moved = null;
  buttons = 0;
  sendInput({type: "leave"});
}

canvas.addEventListener("pointermove", onPointer);
canvas.addEventListener("pointerup", onPointer);
canvas.addEventListener("pointerdown", (event) => {
  canvas.setPointerCapture(event.pointerId);
  isFinger = event.pointerType === "touch";
  if (document.activeElement !== typed) canvas.focus();
  onPointer(event);
  event.preventDefault();
});
canvas.addEventListener("pointercancel", (event) => event.isPrimary && leave());
canvas.addEventListener("pointerleave", (event) => {
  if (event.pointerType !== "touch") leave();  // a finger that is lifted has said so
});
canvas.addEventListener("contextmenu", (event) => event.preventDefault());
canvas.addEventListener("wheel", (event) => {
  event.preventDefault();
  flushMove();
  const notch = [100, 3, 1][event.deltaMode];  // pixels, lines, pages
  sendInput({type: "wheel", ...placeOf(event), right: -event.deltaX / notch, up: -event.deltaY / notch});
}, {passive: false});

// --------------------------------------------------------------------------------------------------- keyboard

let down = new Set();

function press(key) {
  sendInput({type: "key", key, down: true});
  sendInput({type: "key", key, down: false});
}

function onKey(event, isDown) {
  if (event.isComposing || event.metaKey || event.target === control || event.target === keyboard) return;
  if (keys.includes(event.key)) {
    if (event.altKey && event.key.startsWith("Arrow")) return;  // the browser's history
    if (event.key !== "Tab") event.preventDefault();
    // A key that is held down repeats by itself over there.
    if (isDown && event.repeat && !["ArrowLeft", "ArrowRight", "Backspace", "Delete"].includes(event.key)) return;
    if (isDown && down.has(event.key)) sendInput({type: "key", key: event.key, down: false});
    isDown ? down.add(event.key) : down.delete(event.key);
    sendInput({type: "key", key: event.key, down: isDown});
    if (isDown && event.key === " ") sendInput({type: "text", text: " "});  // it is both
  } else if (isDown && event.target !== typed && event.key.length === 1 &&
             (!(event.ctrlKey || event.altKey) || event.getModifierState("AltGraph"))) {
    sendInput({type: "text", text: event.key});
  }
}
window.addEventListener("keydown", (event) => onKey(event, true));
window.addEventListener("keyup", (event) => onKey(event, false));

// Keyboards on a screen tell no keys, and change words while they are written: what is different in the field goes
// over. It is never empty, so that there is something to take away.
const filling = "____";
let known = filling;

function refill() {
  typed.value = known = filling;
  typed.setSelectionRange(filling.length, filling.length);
}

function onTyped(event) {
  const value = typed.value;
  let same = 0;
  while (same < known.length && known[same] === value[same]) ++same;
  for (let i = same; i < known.length; ++i) press("Backspace");
  for (const character of value.slice(same)) sendInput({type: "text", text: character});
  known = value;
  if (!event.isComposing) refill();
}
typed.addEventListener("input", onTyped);
typed.addEventListener("compositionend", refill);
typed.addEventListener("focus", refill);

window.addEventListener("blur", () => {
  down = new Set();
  leave();
});

// --------------------------------------------------------------------------------------------------- pictures

let decoder = null;
let decoding = [];        // headers of the pictures in it
let decodingSince = 0;    // timer
let canDecode = true;     // until it has failed
const patience = 4000;    // ms, for a picture to come out of it
let shown = 0;            // number of the picture

// `image` is drawn and given back; then another may come.
function show(image, header) {
  if (header.from === socket && header.picture > shown) {  // else a newer one is there already
    draw(image, header);
    acknowledge(header);
  }
  image.close();
}

function draw(image, header) {
  if (canvas.width !== header.width || canvas.height !== header.height) {
    canvas.width = header.width;
    canvas.height = header.height;
  }
  paper.drawImage(image, 0, 0);
  shown = header.picture;
  stats.pictures += 1;
  stats.sharp += header.isSharp ? 1 : 0;
  stats.isSharp = header.isSharp;
  stats.width = header.width;
  stats.height = header.height;
  const now = performance.now();
  while (sent.length > 0 && sent[0].n <= header.input) stats.latencies.push(now - sent.shift().at);
  if (stats.latencies.length > 10000) stats.latencies.splice(0, 5000);
}

function acknowledge(header) {
  if (header.from === socket) send({type: "ack", picture: header.picture});
}

// Pictures in their order, as making one may take longer than making the next.
let line = Promise.resolve();

function showJpeg(header, bytes) {
  const image = createImageBitmap(new Blob([bytes], {type: "image/jpeg"}));
  image.catch(() => {});  // it is seen to in its turn
  line = line.then(() => image).then((made) => show(made, header), () => acknowledge(header));
}

function showVideo(header, bytes) {
  if (!decoder) return acknowledge(header);
  decoding.push(header);
  try {
    decoder.decode(new EncodedVideoChunk(
      {type: header.kind === kinds.h264Key ? "key" : "delta", timestamp: header.picture, data: bytes}));
  } catch {
    return giveUpVideo();
  }
  if (decoding.length === 1) watchDecoder();
}

// A decoder that keeps pictures back would keep the next from coming.
function watchDecoder() {
  clearTimeout(decodingSince);
  if (decoding.length > 0) decodingSince = setTimeout(giveUpVideo, patience);
}

function openDecoder() {
  closeDecoder();
  decoder = new VideoDecoder({
    output(frame) {
      const header = decoding.shift();
      watchDecoder();
      if (!header) return frame.close();
      line = line.then(() => show(frame, header));
    },
    error: giveUpVideo,
  });
  decoder.configure({codec: codecOfVideo, optimizeForLatency: true});
}

function closeDecoder() {
  if (decoder && decoder.state !== "closed") decoder.close();
  decoder = null;
  decoding = [];
  clearTimeout(decodingSince);
}

function giveUpVideo() {
  closeDecoder();
  canDecode = false;
  hello("jpeg");
}

function hello(codec) {
  stats.codec = codec;
  send({type: "hello", codec});
}

async function bestCodec() {
  if (location.hash === "#jpeg" || !canDecode || !("VideoDecoder" in window)) return "jpeg";
  try {
    const answer = await VideoDecoder.isConfigSupported({codec: codecOfVideo, optimizeForLatency: true});
    return answer.supported ? "h264" : "jpeg";
  } catch {
    return "jpeg";
  }
}

// ---------------------------------------------------------------------------------------------------- notices

function say(text, canTakeControl = false) {
  said.textContent = text;
  control.hidden = !canTakeControl;
  bar.hidden = text === "" && keyboard.hidden;
}

// Some phones bring up their keyboard for nothing but a finger on something that asks for it.
function offerKeyboard(isWanted) {
  keyboard.hidden = !isWanted;
  bar.hidden = said.textContent === "" && keyboard.hidden;
}

control.addEventListener("click", () => send({type: "control"}));
keyboard.addEventListener("click", () => typed.focus({preventScroll: true}));

function end(text) {
  hasEnded = true;
  say(text);
}

function onNotice(notice) {
  if ("role" in notice) {
    stats.role = notice.role;
    sent = [];
    inputs = 0;
    down = new Set();
    const controls = notice.role === "controller";
    say(controls ? "" : "You are looking on.", !controls && notice.mayControl);
    canvas.style.cursor = "default";
    if (controls) sendSize();
  }
  if ("cursor" in notice) canvas.style.cursor = notice.cursor;
  if ("keyboard" in notice) {
    (notice.keyboard ? typed : canvas).focus({preventScroll: true});
    offerKeyboard(notice.keyboard && isFinger);
  }
  if ("saved" in notice) {
    const link = document.createElement("a");
    link.href = notice.saved;
    link.download = notice.saved.split("/").pop();
    document.body.append(link);
    link.click();
    link.remove();
  }
  if ("ended" in notice) end(notice.ended);
}

// ------------------------------------------------------------------------------------------------- connection

function onMessage(event) {
  if (event.target !== socket) return;
  const view = new DataView(event.data);
  const header = {
    from: event.target, kind: view.getUint8(0), isSharp: view.getUint8(1) === 1, picture: view.getUint32(4, true),
    input: view.getUint32(8, true), width: view.getUint16(12, true), height: view.getUint16(14, true),
  };
  const content = new Uint8Array(event.data, headerBytes);
  stats.bytes += event.data.byteLength;
  if (header.kind === kinds.notice) onNotice(JSON.parse(new TextDecoder().decode(content)));
  else if (header.kind === kinds.jpeg) showJpeg(header, content);
  else showVideo(header, content);
  if (header.kind === kinds.jpeg && !header.isSharp) stats.codec = "jpeg";  // whatever it was asked for
}

// Whether the server knows us: one that was started anew has other secrets.
async function isRefused() {
  try {
    return (await fetch("viewer.css", {method: "HEAD", cache: "no-store"})).status === 403;
  } catch {
    return false;  // it is not there
  }
}

async function connect() {
  const codec = await bestCodec();
  let wasOpen = false;
  socket = new WebSocket(`ws://${location.host}/ws`);
  socket.binaryType = "arraybuffer";
  socket.onopen = () => {
    wasOpen = true;
    delay = 250;
    shown = 0;
    say("");
    if (codec === "h264") openDecoder();
    hello(codec);
  };
  socket.onmessage = onMessage;
  socket.onclose = async (event) => {
    closeDecoder();
    stats.role = "";
    offerKeyboard(false);
    if (event.code === 1001 && event.reason) end(event.reason);  // it has said goodbye
    if (hasEnded) return;
    say("The connection is lost; trying again ...");
    if (!wasOpen && await isRefused()) return end("This address is no longer good: open the one that was printed last.");
    setTimeout(connect, delay);
    delay = Math.min(2 * delay, 8000);
  };
}

connect();
