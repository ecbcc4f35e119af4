// SPDX-License-Identifier: MIT
// A client of `bedmix view` that is no browser: it shows nothing and acknowledges at once. With Node's own parts
// alone, as Node 18 has no WebSocket.
import {randomBytes} from "node:crypto";
import http from "node:http";

const opcode = {text: 1, binary: 2, close: 8, ping: 9, pong: 10};
export const kinds = {jpeg: 1, h264Key: 2, h264Next: 3, notice: 4};

/** What a browser sends along when a page opens its WebSocket. */
export function upgradeHeaders(url) {
  const {port, origin, searchParams} = new URL(url);
  return {Connection: "Upgrade", Upgrade: "websocket", "Sec-WebSocket-Version": "13",
          "Sec-WebSocket-Key": randomBytes(16).toString("base64"),
          Cookie: `bedmix-${port}=${searchParams.get("token")}`, Origin: origin};
}

/** A frame of the client's, masked as they must be. */
function frame(code, content) {
  const mask = randomBytes(4), length = content.length;
  const start = length < 126 ? Buffer.from([0x80 | code, 0x80 | length])
                             : Buffer.from([0x80 | code, 0x80 | 126, length >> 8, length & 255]);
  const masked = Buffer.from(content);
  for (let i = 0; i < length; ++i) masked[i] ^= mask[i & 3];
  return Buffer.concat([start, mask, masked]);
}

export class Client {
  pictures = 0;
  bytes = 0;
  latencies = [];  // ms from an input to the first picture that shows what came of it
  role = "";
  codec = "";      // of the last picture that is not sharp
  closed = null;   // {code, reason}
  #inputs = 0;
  #sent = [];
  #rest = Buffer.alloc(0);

  static open(url, codec = "h264") {
    return new Promise((resolve, reject) => {
      const request = http.get(`${new URL(url).origin}/ws`, {headers: upgradeHeaders(url), agent: false});
      request.on("error", reject);
      request.on("response", (answer) => reject(new Error(`no WebSocket: ${answer.statusCode}`)));
      request.on("upgrade", (_, socket, head) => {
        const client = new Client();
        client.socket = socket.setNoDelay(true);
        socket.on("data", (data) => client.#take(data));
        socket.on("error", () => {});
        client.send({type: "hello", codec});
        client.#take(head);
        resolve(client);
      });
    });
  }

  send(message) { this.socket.write(frame(opcode.text, Buffer.from(JSON.stringify(message)))); }

  /** Whether or not it is the one who steers. */
  input(message) {
    this.#sent.push({n: ++this.#inputs, at: performance.now()});
    this.send({...message, n: this.#inputs});
  }

  resetStats() {
    Object.assign(this, {pictures: 0, bytes: 0, latencies: []});
    this.#sent = [];
  }

  close() { this.socket.destroy(); }

  #take(data) {
    this.#rest = this.#rest.length === 0 ? data : Buffer.concat([this.#rest, data]);
    for (let next = this.#frame(); next; next = this.#frame()) this.#onFrame(...next);
  }

  /** The next frame, if it is whole. */
  #frame() {
    const rest = this.#rest;
    if (rest.length < 2) return null;
    let start = 2, length = rest[1] & 127;
    if (rest.length < 10 && length > 125) return null;
    if (length === 126) [start, length] = [4, rest.readUInt16BE(2)];
    else if (length === 127) [start, length] = [10, Number(rest.readBigUInt64BE(2))];
    if (rest.length < start + length) return null;
    this.#rest = rest.subarray(start + length);
    return [rest[0] & 15, (rest[0] & 128) !== 0, rest.subarray(start, start + length)];
  }

  #message = [];
  #onFrame(code, isLast, content) {
    if (code === opcode.ping) return this.socket.write(frame(opcode.pong, content));
    if (code === opcode.close)
      this.closed = {code: content.length > 1 ? content.readUInt16BE(0) : 0, reason: content.subarray(2).toString()};
    if (code > opcode.binary) return;
    this.#message.push(content);
    if (isLast) this.#onMessage(Buffer.concat(this.#message.splice(0)));
  }

  #onMessage(message) {
    const kind = message[0];
    this.bytes += message.length;
    if (kind === kinds.notice) {
      const notice = JSON.parse(message.subarray(16).toString());
      if (notice.role) [this.role, this.#inputs, this.#sent] = [notice.role, 0, []];
      return;
    }
    ++this.pictures;
    if (message[1] === 0) this.codec = kind === kinds.jpeg ? "jpeg" : "h264";
    const now = performance.now(), input = message.readUInt32LE(8);
    while (this.#sent.length > 0 && this.#sent[0].n <= input) this.latencies.push(now - this.#sent.shift().at);
    this.send({type: "ack", picture: message.readUInt32LE(4)});
  }
}
