// Pictures: workers trace them, as the program plans, and they wait here, by their times, until it shows them.
const pictures = new Map, cores = navigator.hardwareConcurrency || 2
let count, w, h, tracers = [], solver, idle, spare = [], lit, solved, unlit
let turn = 0, shown = 0, skipped = 0, first = 0 // turn: how often the viewer has sought
const startWorker = (heard, ...first) => {
  const k = new Worker(url)
  k.onerror = e => fail('The film has stopped: ' + e.message)
  k.onmessage = ({ data }) => data.wrong ? (k == solver ? leaveOut : fail)(data.wrong) : heard(data, k)
  k.postMessage(first)
  return k
}
const paint = rgba => draw.putImageData(new ImageData(new Uint8ClampedArray(rgba.buffer), w, h), 0, 0)
const forget = (time, rgba) => { spare.push(rgba), pictures.delete(time) }
// From then on; what was planned before is forgotten
const beginPictures = () => {
  pictures.forEach((rgba, time) => forget(time, rgba))
  x.begin(from, w, h, count)
}
const give = () => {
  for (let at; idle.length && !over && (at = x.plan(filmAt())); ) {
    const [time, level, width, height] = new Float64Array(x.memory.buffer, at, 4), rgba = spare.pop()
    idle.pop().postMessage(['picture', { turn, time, level, width, height }, rgba], rgba ? [rgba.buffer] : [])
  }
}
// The light of the hall, which goes from worker to worker, so that it stands in memory once
const light = hall => {
  const to = tracers[lit++] ?? solver
  to.postMessage(['light', hall], [hall.pages.buffer])
  if (lit == count) x.hall(0), release('hall'), give()
}
const leaveOut = why => {
  unlit = `The light of the hall could not be solved (${why}): its scenes are left out.`
  x.hall(2), release('hall'), give()
}
const heardTracer = (d, k) => {
  if (d.hall) return light(d.hall)
  if (d.still) return playing || paint(d.rgba)
  if (d.turn == turn) {
    x.traced(d.time, d.trace / 1e3, d.samples, d.width)
    pictures.set(d.time, d.rgba)
  } else if (d.rgba)
    spare.push(d.rgba)
  idle.push(k), give()
}
// Shows what is due when the film is at that time, and forgets what was before
const showDue = (film, t) => {
  const due = x.due(film)
  if (due < 0) return
  paint(pictures.get(due))
  if (!shown++) first = now()
  x.shown(film - from, now() - t)
  for (const [time, rgba] of pictures)
    if (time <= due) skipped += time < due, forget(time, rgba)
}
// What workers draw is as large as the screen, so that they are ready before the click; or as the page at the click,
// which may have had another size, or none
const prepare = () => {
  const dpr = devicePixelRatio || 1, most = cores > 4 ? 1920 : 1280
  const [across, down] = (full ? [screen.width, screen.height] : [innerWidth || 1280, innerHeight || 720])
    .sort((a, b) => b - a)
  const wide = Math.max(16, Math.min(most, Math.round(across * dpr)))
  const high = Math.max(9, Math.round(wide * down / across))
  if (wide == w && high == h) return
  for (const k of tracers) k.terminate()
  solver?.terminate()
  canvas.width = w = wide, canvas.height = h = high
  idle = [], unlit = null, lit = solved = 0
  x.hall(1), beginPictures() // 0: lit, 1: not yet, 2: never
  spare = []
  tracers = Array.from({ length: count }, () => startWorker(heardTracer, 'trace', module, w, h))
  tracers[0].postMessage(['picture', { time: 35, level: 1, width: 0, height: 0, still: 1 }])
  solver = startWorker(d => {
    if (d.progress) solved = d.progress
    if (d.hall) solver.terminate(), light(d.hall)
  }, 'solve', module, w, h)
  solver.onerror = e => leaveOut(e.message)
}
