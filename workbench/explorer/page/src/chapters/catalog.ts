/** The chapters, in the order in which the page lists them. */

import type { AnyChapter } from "../kit/chapter";
import { motionChapter } from "./motion";
import { shortChapter } from "./short";
import { smallestZonogon } from "./smallest_zonogon";
import { againChapter } from "./again";
import { insideChapter } from "./inside";
import { tilingChapter } from "./tiling";
import { volumesChapter } from "./volumes";

export const chapters: readonly AnyChapter[] = [
  smallestZonogon,
  tilingChapter,
  insideChapter,
  shortChapter,
  againChapter,
  motionChapter,
  volumesChapter,
];
