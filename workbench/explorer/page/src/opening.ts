/** The first script of the page: it unpacks the one that holds everything else, and begins it. */

import { unpackedElement } from "./unpack/element";

const script = document.createElement("script");
script.textContent = new TextDecoder().decode(unpackedElement("script"));
document.body.append(script);
