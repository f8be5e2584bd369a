/**
 * Unpacks LZMA, which no browser does by itself and which makes the library a third smaller than gzip.
 *
 * A file begins with 13 bytes: the parameters of the model, the size of its window, and the length of the content. Then
 * comes a stream of a range coder. Each bit of it is told by a model that has counted how often this bit was zero: the
 * bits say whether a literal byte follows or a copy of earlier bytes, from how far back and how many.
 */

const HEADER = 13;
/** Probabilities of zero are fractions of 2^11. */
const ONE = 1 << 11;
/** A probability goes this part, as a power of two, of the way to what was seen. */
const ADAPTATION = 5;
const FULL_RANGE = 1 << 24;

const STATES = 12;
/** After these states, the last symbol was a literal. */
const AFTER_LITERAL = 7;
const POSITIONS = 16;
const LITERAL = 0x300;
const SHORTEST = 2;
const DISTANCE_SLOTS = 64;
/** Distances of the slots from here on end with bits of equal probability and four aligned ones. */
const FIRST_LONG_SLOT = 14;
const ALIGNED_BITS = 4;

/** The models of a length: two choices, then 3 bits for each position, 3 bits for each position, or 8 bits. */
const [MIDDLE, HIGH, LENGTHS] = [2 + POSITIONS * 8, 2 + 2 * POSITIONS * 8, 2 + 2 * POSITIONS * 8 + 256];

/** The places of the models in one list. */
const IS_COPY = 0;
const IS_AGAIN = IS_COPY + STATES * POSITIONS;
const IS_NOT_LAST = IS_AGAIN + STATES;
const IS_NOT_SECOND = IS_NOT_LAST + STATES;
const IS_NOT_THIRD = IS_NOT_SECOND + STATES;
const IS_LONG = IS_NOT_THIRD + STATES;
const SLOT = IS_LONG + STATES * POSITIONS;
const NEAR = SLOT + 4 * DISTANCE_SLOTS;
const ALIGNED = NEAR + 128;
const NEW_LENGTH = ALIGNED + 16;
const AGAIN_LENGTH = NEW_LENGTH + LENGTHS;
const LITERALS = AGAIN_LENGTH + LENGTHS;

class RangeDecoder {
  private range = 0xffffffff;
  private code = 0;
  private at = HEADER + 1;

  constructor(private readonly packed: Uint8Array) {
    for (let byte = 0; byte < 4; byte += 1) this.code = ((this.code << 8) | this.next()) >>> 0;
  }

  private next(): number {
    return this.packed[this.at++] as number;
  }

  /** A bit with the model at a place of a list. */
  bit(models: Uint16Array, place: number): number {
    const zero = models[place] as number;
    const bound = (this.range >>> 11) * zero;
    let bit = 0;
    if (this.code < bound) {
      this.range = bound;
      models[place] = zero + ((ONE - zero) >> ADAPTATION);
    } else {
      this.range -= bound;
      this.code -= bound;
      models[place] = zero - (zero >> ADAPTATION);
      bit = 1;
    }
    if (this.range < FULL_RANGE) this.refill();
    return bit;
  }

  /** Bits of equal probability, the highest first. */
  plain(count: number): number {
    let value = 0;
    for (; count > 0; count -= 1) {
      this.range >>>= 1;
      const bit = this.code < this.range ? 0 : 1;
      if (bit === 1) this.code -= this.range;
      value = (value << 1) | bit;
      if (this.range < FULL_RANGE) this.refill();
    }
    return value;
  }

  /** A number of some bits, the highest first; every beginning of it has a model of its own. */
  tree(models: Uint16Array, place: number, bits: number): number {
    let node = 1;
    for (let depth = 0; depth < bits; depth += 1) node = (node << 1) | this.bit(models, place + node);
    return node - (1 << bits);
  }

  /** The same with the lowest bit first. */
  reversed(models: Uint16Array, place: number, bits: number): number {
    let [node, value] = [1, 0];
    for (let depth = 0; depth < bits; depth += 1) {
      const bit = this.bit(models, place + node);
      node = (node << 1) | bit;
      value |= bit << depth;
    }
    return value;
  }

  private refill(): void {
    this.range = (this.range << 8) >>> 0;
    this.code = ((this.code << 8) | this.next()) >>> 0;
  }
}

export function unpackedLzma(packed: Uint8Array): Uint8Array<ArrayBuffer> {
  const header = new DataView(packed.buffer, packed.byteOffset, HEADER);
  const parameters = header.getUint8(0);
  const contextBits = parameters % 9;
  const literalPositions = (1 << Math.floor(parameters / 9) % 5) - 1;
  const positions = (1 << Math.floor(parameters / 45)) - 1;
  const content = new Uint8Array(header.getUint32(5, true));
  const models = new Uint16Array(LITERALS + (LITERAL << contextBits) * (literalPositions + 1)).fill(ONE >> 1);
  const coder = new RangeDecoder(packed);
  let [state, at] = [0, 0];
  /** The last four distances, the latest first. */
  let [last, second, third, fourth] = [1, 1, 1, 1];

  const length = (place: number, position: number): number => {
    if (coder.bit(models, place) === 0) return SHORTEST + coder.tree(models, place + 2 + position * 8, 3);
    if (coder.bit(models, place + 1) === 0) return SHORTEST + 8 + coder.tree(models, place + MIDDLE + position * 8, 3);
    return SHORTEST + 16 + coder.tree(models, place + HIGH, 8);
  };

  const distance = (copied: number): number => {
    const slot = coder.tree(models, SLOT + Math.min(copied - SHORTEST, 3) * DISTANCE_SLOTS, 6);
    if (slot < 4) return slot + 1;
    const bits = (slot >> 1) - 1;
    const first = (2 | (slot & 1)) << bits;
    if (slot < FIRST_LONG_SLOT) return first + coder.reversed(models, NEAR + first - slot, bits) + 1;
    const middle = coder.plain(bits - ALIGNED_BITS) << ALIGNED_BITS;
    return first + middle + coder.reversed(models, ALIGNED, ALIGNED_BITS) + 1;
  };

  const literal = (): number => {
    const before = at > 0 ? (content[at - 1] as number) : 0;
    const context = ((at & literalPositions) << contextBits) + (before >> (8 - contextBits));
    const place = LITERALS + LITERAL * context;
    let node = 1;
    if (state >= AFTER_LITERAL) {
      // The byte that a copy would have put here is unlikely, and the models know its bits until one is different.
      let [likely, alike] = [content[at - last] as number, true];
      while (node < 0x100 && alike) {
        const expected = (likely >> 7) & 1;
        likely <<= 1;
        const bit = coder.bit(models, place + 0x100 + (expected << 8) + node);
        node = (node << 1) | bit;
        alike = bit === expected;
      }
    }
    while (node < 0x100) node = (node << 1) | coder.bit(models, place + node);
    return node;
  };

  while (at < content.length) {
    const position = at & positions;
    if (coder.bit(models, IS_COPY + state * POSITIONS + position) === 0) {
      content[at] = literal();
      at += 1;
      state = state < 4 ? 0 : state < 10 ? state - 3 : state - 6;
      continue;
    }
    const isAfterLiteral = state < AFTER_LITERAL;
    let copied: number;
    if (coder.bit(models, IS_AGAIN + state) === 0) {
      copied = length(NEW_LENGTH, position);
      state = isAfterLiteral ? 7 : 10;
      [fourth, third, second, last] = [third, second, last, distance(copied)];
    } else {
      let isOneByte = false;
      if (coder.bit(models, IS_NOT_LAST + state) === 0) {
        isOneByte = coder.bit(models, IS_LONG + state * POSITIONS + position) === 0;
      } else if (coder.bit(models, IS_NOT_SECOND + state) === 0) {
        [last, second] = [second, last];
      } else if (coder.bit(models, IS_NOT_THIRD + state) === 0) {
        [last, second, third] = [third, last, second];
      } else {
        [last, second, third, fourth] = [fourth, last, second, third];
      }
      copied = isOneByte ? 1 : length(AGAIN_LENGTH, position);
      state = isOneByte ? (isAfterLiteral ? 9 : 11) : isAfterLiteral ? 8 : 11;
    }
    for (const end = at + copied; at < end; at += 1) content[at] = content[at - last] as number;
  }
  return content;
}
