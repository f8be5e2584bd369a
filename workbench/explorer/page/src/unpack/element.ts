/** Parts of the page that are written into it as packed letters. */

import { fromLetters } from "./letters";
import { unpackedLzma } from "./lzma";

/** The bytes of the part that the element of this name holds. */
export function unpackedElement(id: string): Uint8Array<ArrayBuffer> {
  return unpackedLzma(fromLetters(document.getElementById(id)?.textContent ?? ""));
}
