"use strict";
/* What makes figures answer a pointer is kept deflated: length of the JSON, JSON with scripts and panels, numbers. A browser that cannot inflate shows them still. */
(async function () {
  const held = document.getElementById("live");
  if (!held || !window.DecompressionStream) return;
  const letters = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz!#$%&()*+-;<=>?@^_`{|}~", text = held.textContent, left = text.length % 5;
  const raw = new Uint8Array(Math.ceil(text.length / 5) * 4), view = new DataView(raw.buffer), places = new Map([...letters].map((letter, k) => [letter, k]));
  for (let at = 0; at < text.length; at += 5) {
    let word = 0;
    for (let k = at; k < at + 5; k++) word = word * 85 + (places.get(text[k]) ?? 84);
    view.setUint32((at / 5) * 4, word);
  }
  const bytes = new Uint8Array(await new Response(new Blob([raw.subarray(0, raw.length - (left && 5 - left))]).stream().pipeThrough(new DecompressionStream("deflate"))).arrayBuffer());
  const end = 4 + new DataView(bytes.buffer).getUint32(0, true), given = JSON.parse(new TextDecoder().decode(bytes.subarray(4, end)));
  for (const text of given.scripts) document.head.append(Object.assign(document.createElement("script"), { textContent: text }));
  liveFigures(given, bytes.subarray(end));
})();
