// Draws text that the app's font does not hold, as the browser does it: with its fonts for every script, with joined
// letters, and in the direction of the script.

/** Device pixels; what is longer is cut off, as a panel would cut it off. */
const WIDEST = 2000
/** In sizes of the text: stacks of combining marks have no end of their own. */
const HIGHEST = 4

let canvas

function prepare(context, pixels) {
  context.font = `500 ${pixels}px Inter, system-ui, sans-serif`
  context.fillStyle = '#fff'
}

/** Whether something keeps colours of its own, as an emoji does, when the text is to be white. */
function isColoured(pixels) {
  for (let at = 0; at < pixels.length; at += 4) {
    const isSeen = pixels[at + 3] > 40
    if (isSeen && Math.min(pixels[at], pixels[at + 1], pixels[at + 2]) < 200) return true
  }
  return false
}

/**
 * A text in white on nothing, in device pixels: `pixels` are bytes of RGBA, `figures` the picture's width and height,
 * from its left edge to where the text begins, from its upper edge to the baseline, how far the text reaches, and 1 if
 * it keeps its own colours. Null where there is no canvas.
 */
export function drawText(text, pixels) {
  canvas ??= document.createElement('canvas')
  const context = canvas.getContext('2d', { willReadFrequently: true })
  if (!context) return null
  prepare(context, pixels)
  const box = context.measureText(text)
  const highest = HIGHEST * pixels
  // A pixel more on each side, so that neighbours in the app's texture do not bleed into one another.
  const left = Math.ceil(Math.min(Math.max(box.actualBoundingBoxLeft, 0), highest)) + 1
  const ascent = Math.ceil(Math.min(Math.max(box.actualBoundingBoxAscent, 0), highest)) + 1
  const right = Math.ceil(Math.min(Math.max(box.actualBoundingBoxRight, 0), WIDEST)) + 1
  const descent = Math.ceil(Math.min(Math.max(box.actualBoundingBoxDescent, 0), highest)) + 1
  canvas.width = Math.min(left + right, WIDEST)
  canvas.height = ascent + descent
  prepare(context, pixels)
  context.fillText(text, left, ascent)
  const drawn = context.getImageData(0, 0, canvas.width, canvas.height).data
  const advance = Math.min(box.width, WIDEST)
  return {
    pixels: drawn,
    figures: [canvas.width, canvas.height, left, ascent, advance, isColoured(drawn) ? 1 : 0],
  }
}
