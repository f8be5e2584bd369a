/** Both directions of what the page is packed by, for the script that packs it. */

export { fromLetters, toLetters } from "./letters";
export { unpackedLzma } from "./lzma";
