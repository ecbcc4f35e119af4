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
const control = document.getElementById("control");

// What a test or a benchmark wants to know.
const stats = {
  pictures: 0, bytes: 0, sharp: 0, codec: "", role: "", width: 0, height: 0, startedAt: performance.now(), latencies: [],
  reset() { Object.assign(this, {pictures: 0, bytes: 0, sharp: 0, startedAt: performance.now(), latencies: []}); },
};
window.bedmixStats = stats;

let socket = null, decoder = null, delay = 250, hasEnded = false;
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

// How many pixels of the picture there are per CSS pixel.
let scale = 1;

function sendSize() {
  const area = window.innerWidth * window.innerHeight;
  scale = Math.min(window.devicePixelRatio || 1, 4, Math.sqrt(mostPixels / area),
                   mostSide / Math.max(window.innerWidth, window.innerHeight));
  const side = (css) => Math.max(16, 2 * Math.floor(css * scale / 2));
  sendInput({type: "size", width: side(window.innerWidth), height: side(window.innerHeight),
             scale: Math.min(4, Math.max(0.5, scale))});
}

let resizing = 0;
window.addEventListener("resize", () => {
  clearTimeout(resizing);
  resizing = setTimeout(sendSize, 100);
});

// ---------------------------------------------------------------------------------------------------- pointer

// Where something happened, in pixels of the picture.
function placeOf(event) {
  return {x: event.clientX * canvas.width / window.innerWidth, y: event.clientY * canvas.height / window.innerHeight};
}

const pointerMessage = (event, buttons) =>
  ({type: "pointer", ...placeOf(event), buttons: buttons & 7, touch: event.pointerType === "touch"});

let moved = null;  // the last move of this animation frame

function flushMove() {
  if (moved) sendInput(moved);
  moved = null;
}

canvas.addEventListener("pointermove", (event) => {
  if (event.pointerType === "touch" && !event.isPrimary) return;
  if (!moved) requestAnimationFrame(flushMove);
  moved = pointerMessage(event, event.buttons);
});
for (const kind of ["pointerdown", "pointerup"])
  canvas.addEventListener(kind, (event) => {
    if (event.pointerType === "touch" && !event.isPrimary) return;
    if (kind === "pointerdown") {
      canvas.setPointerCapture(event.pointerId);
      if (document.activeElement !== typed) canvas.focus();
    }
    flushMove();
    sendInput(pointerMessage(event, event.buttons));
    event.preventDefault();
  });
canvas.addEventListener("pointercancel", () => sendInput({type: "leave"}));
canvas.addEventListener("pointerleave", (event) => {
  if (event.pointerType === "touch") return;  // a finger that is lifted has said so
  moved = null;
  sendInput({type: "leave"});
});
canvas.addEventListener("contextmenu", (event) => event.preventDefault());
canvas.addEventListener("wheel", (event) => {
  event.preventDefault();
  const notch = [100, 3, 1][event.deltaMode];  // pixels, lines, pages
  sendInput({type: "wheel", ...placeOf(event), right: -event.deltaX / notch, up: -event.deltaY / notch});
}, {passive: false});

// --------------------------------------------------------------------------------------------------- keyboard

let down = new Set();

function onKey(event, isDown) {
  if (event.isComposing || event.metaKey) return;
  if (keys.includes(event.key)) {
    // A key that is held down repeats by itself over there.
    if (isDown && event.repeat && !["ArrowLeft", "ArrowRight", "Backspace", "Delete"].includes(event.key)) return;
    if (isDown && down.has(event.key)) sendInput({type: "key", key: event.key, down: false});
    isDown ? down.add(event.key) : down.delete(event.key);
    sendInput({type: "key", key: event.key, down: isDown});
    if (event.key !== "Tab") event.preventDefault();
  } else if (isDown && event.target !== typed && event.key.length === 1 && !event.ctrlKey && !event.altKey) {
    sendInput({type: "text", text: event.key});
  }
}
window.addEventListener("keydown", (event) => onKey(event, true));
window.addEventListener("keyup", (event) => onKey(event, false));
typed.addEventListener("input", () => {
  for (const character of typed.value) sendInput({type: "text", text: character});
  typed.value = "";
});
window.addEventListener("blur", () => {
  down = new Set();
  sendInput({type: "leave"});
});

// --------------------------------------------------------------------------------------------------- pictures

// `image` is drawn and given back; then another may come.
function show(image, header) {
  if (canvas.width !== header.width || canvas.height !== header.height) {
    canvas.width = header.width;
    canvas.height = header.height;
  }
  paper.drawImage(image, 0, 0);
  image.close();
  stats.pictures += 1;
  stats.sharp += header.isSharp ? 1 : 0;
  stats.width = header.width;
  stats.height = header.height;
  const now = performance.now();
  while (sent.length > 0 && sent[0].n <= header.input) stats.latencies.push(now - sent.shift().at);
  if (stats.latencies.length > 10000) stats.latencies.splice(0, 5000);
  send({type: "ack", picture: header.picture});
}

// Pictures in their order, as decoding one may take longer than decoding the next.
let line = Promise.resolve();

function showJpeg(header, bytes) {
  const image = createImageBitmap(new Blob([bytes], {type: "image/jpeg"}));
  line = line.then(() => image).then((made) => show(made, header),
                                     () => send({type: "ack", picture: header.picture}));
}

let decoding = [];  // headers of the pictures in the decoder

function showVideo(header, bytes) {
  if (!decoder) return send({type: "ack", picture: header.picture});
  decoding.push(header);
  decoder.decode(new EncodedVideoChunk(
    {type: header.kind === kinds.h264Key ? "key" : "delta", timestamp: header.picture, data: bytes}));
}

function openDecoder() {
  closeDecoder();
  decoder = new VideoDecoder({
    output(frame) {
      const header = decoding.shift();
      line = line.then(() => show(frame, header));
    },
    error() {
      closeDecoder();
      hello("jpeg");
    },
  });
  decoder.configure({codec: codecOfVideo, optimizeForLatency: true});
}

function closeDecoder() {
  if (decoder && decoder.state !== "closed") decoder.close();
  decoder = null;
  decoding = [];
}

function hello(codec) {
  stats.codec = codec;
  send({type: "hello", codec});
}

async function bestCodec() {
  if (location.hash === "#jpeg" || !("VideoDecoder" in window)) return "jpeg";
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
  bar.hidden = text === "";
}

control.addEventListener("click", () => send({type: "control"}));

function onNotice(notice) {
  if ("role" in notice) {
    stats.role = notice.role;
    sent = [];
    inputs = 0;
    const controls = notice.role === "controller";
    say(controls ? "" : "You are looking on.", !controls && notice.mayControl);
    if (controls) sendSize();
  }
  if ("cursor" in notice) canvas.style.cursor = notice.cursor;
  if ("keyboard" in notice) (notice.keyboard ? typed : canvas).focus();
  if ("saved" in notice) {
    const link = document.createElement("a");
    link.href = notice.saved;
    link.download = notice.saved.split("/").pop();
    link.click();
  }
}

// ------------------------------------------------------------------------------------------------- connection

function onMessage(event) {
  const view = new DataView(event.data);
  const header = {
    kind: view.getUint8(0), isSharp: view.getUint8(1) === 1, picture: view.getUint32(4, true),
    input: view.getUint32(8, true), width: view.getUint16(12, true), height: view.getUint16(14, true),
  };
  const content = new Uint8Array(event.data, headerBytes);
  stats.bytes += event.data.byteLength;
  if (header.kind === kinds.notice) onNotice(JSON.parse(new TextDecoder().decode(content)));
  else if (header.kind === kinds.jpeg) showJpeg(header, content);
  else showVideo(header, content);
}

async function connect() {
  const codec = await bestCodec();
  socket = new WebSocket(`ws://${location.host}/ws`);
  socket.binaryType = "arraybuffer";
  socket.onopen = () => {
    delay = 250;
    say("");
    if (codec === "h264") openDecoder();
    hello(codec);
  };
  socket.onmessage = onMessage;
  socket.onclose = (event) => {
    closeDecoder();
    stats.role = "";
    if (event.code === 1001 && event.reason) {  // it has said goodbye
      hasEnded = true;
      say(event.reason);
    }
    if (hasEnded) return;
    say("The connection is lost; trying again ...");
    setTimeout(connect, delay);
    delay = Math.min(2 * delay, 8000);
  };
}

connect();
