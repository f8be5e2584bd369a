/**
 * Bytes as letters of a page: seven bits each, so that an eighth is lost and not the third that base64 loses.
 *
 * The letter of seven bits is the one of this number in ASCII, which takes one byte. A page does not keep all of them:
 * zero is replaced, a carriage return becomes a line feed, and `</` or `<!` may end or hide the script that holds the
 * text. For these the letter 256 places further is taken, which needs two bytes; seven bits of it are the same.
 */

const FURTHER = 256;

export function toLetters(bytes: Uint8Array): string {
  const letters: string[] = [];
  let [held, bits] = [0, 0];
  const put = (seven: number) =>
    letters.push(String.fromCharCode(seven === 0 || seven === 13 ? seven + FURTHER : seven));
  for (const byte of bytes) {
    held = (held << 8) | byte;
    bits += 8;
    while (bits >= 7) {
      bits -= 7;
      put((held >> bits) & 0x7f);
    }
    held &= 0x7f;
  }
  if (bits > 0) put((held << (7 - bits)) & 0x7f);
  return letters.join("").replace(/<(?=[/!])/g, String.fromCharCode(0x3c + FURTHER));
}

/** The bytes of a text of `toLetters`; up to six last bits fill the last letter and are none of them. */
export function fromLetters(letters: string): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array((letters.length * 7) >> 3);
  let [held, bits, at] = [0, 0, 0];
  for (let place = 0; place < letters.length; place += 1) {
    held = ((held << 7) | (letters.charCodeAt(place) & 0x7f)) & 0x7fff;
    bits += 7;
    if (bits >= 8) {
      bits -= 8;
      bytes[at] = held >> bits;
      at += 1;
    }
  }
  return bytes;
}
