"use strict";
/* What makes figures answer a pointer is kept deflated: length of the JSON, JSON with scripts and panels, numbers. A browser that cannot inflate shows them still. */
(async function () {
  const held = document.getElementById("live");
  if (!held || !window.DecompressionStream) return;
  const raw = Uint8Array.from(atob(held.textContent), letter => letter.charCodeAt(0));
  const bytes = new Uint8Array(await new Response(new Blob([raw]).stream().pipeThrough(new DecompressionStream("deflate"))).arrayBuffer());
  const end = 4 + new DataView(bytes.buffer).getUint32(0, true), given = JSON.parse(new TextDecoder().decode(bytes.subarray(4, end)));
  for (const text of given.scripts) document.head.append(Object.assign(document.createElement("script"), { textContent: text }));
  liveFigures(given, bytes.subarray(end));
})();
