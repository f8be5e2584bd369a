/** Opens the engine from the module that is written into the page: base64 of gzip of WebAssembly. */

import { Engine } from "./engine";

/** The script of the worker, bundled into the page's own. */
declare const WORKER_SCRIPT: string;

export async function openEngine(): Promise<Engine> {
  const inlined = document.getElementById("module")?.textContent?.trim() ?? "";
  const packed = Uint8Array.from(atob(inlined), (letter) => letter.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  const bytes = await new Response(stream).arrayBuffer();
  return Engine.open(await WebAssembly.compile(bytes), WORKER_SCRIPT);
}
