// Importing this registers <knotwork-figure>; where there is no DOM it does nothing.

import { defineFigure } from './element-class.mjs';

export { KnotworkFigure } from './element-class.mjs';

defineFigure();
