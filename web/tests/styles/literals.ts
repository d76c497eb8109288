// Finds colours that are written out instead of named by a token.

/** The colour names of CSS; `transparent` and `currentcolor` are none. */
const kNames = `aliceblue antiquewhite aqua aquamarine azure beige bisque black blanchedalmond blue blueviolet brown burlywood cadetblue chartreuse
chocolate coral cornflowerblue cornsilk crimson cyan darkblue darkcyan darkgoldenrod darkgray darkgreen darkgrey darkkhaki darkmagenta darkolivegreen
darkorange darkorchid darkred darksalmon darkseagreen darkslateblue darkslategray darkslategrey darkturquoise darkviolet deeppink deepskyblue dimgray
dimgrey dodgerblue firebrick floralwhite forestgreen fuchsia gainsboro ghostwhite gold goldenrod gray green greenyellow grey honeydew hotpink indianred
indigo ivory khaki lavender lavenderblush lawngreen lemonchiffon lightblue lightcoral lightcyan lightgoldenrodyellow lightgray lightgreen lightgrey
lightpink lightsalmon lightseagreen lightskyblue lightslategray lightslategrey lightsteelblue lightyellow lime limegreen linen magenta maroon
mediumaquamarine mediumblue mediumorchid mediumpurple mediumseagreen mediumslateblue mediumspringgreen mediumturquoise mediumvioletred midnightblue
mintcream mistyrose moccasin navajowhite navy oldlace olive olivedrab orange orangered orchid palegoldenrod palegreen paleturquoise palevioletred
papayawhip peachpuff peru pink plum powderblue purple rebeccapurple red rosybrown royalblue saddlebrown salmon sandybrown seagreen seashell sienna
silver skyblue slateblue slategray slategrey snow springgreen steelblue tan teal thistle tomato turquoise violet wheat white whitesmoke yellow
yellowgreen`.replace(/\s+/g, "|");

const kHex = "#(?:[0-9a-f]{8}|[0-9a-f]{6}|[0-9a-f]{3,4})(?![\\w-])";
const kFunction = "\\b(?:rgba?|hsla?|hwb|lab|lch|oklab|oklch|light-dark)\\(";

const inValue = new RegExp(`${kHex}|${kFunction}|(?<![\\w-])(?:${kNames})(?![\\w-])`, "gi");
/** A whole string, or a number of six digits; a name only where a colour is given. */
const inCode = new RegExp(
  `(?<=["'\`])${kHex}|${kFunction}|\\b0x[0-9a-f]{6}\\b|(?<=(?:colou?r|background|fill|stroke)["']?\\s*[=:,(]\\s*\\{?\\s*["'\`])(?:${kNames})(?=["'\`])`,
  "gi",
);

const found = (pattern: RegExp, text: string): readonly string[] => [...text.matchAll(pattern)].map(([literal]) => literal);

/** Literal colours in the value of a CSS declaration. */
export const literalsOfValue = (value: string): readonly string[] => found(inValue, value);

/** Literal colours in TypeScript, HTML or SVG. */
export const literalsOfCode = (text: string): readonly string[] => found(inCode, text);
