// The program plans pictures, and workers trace them. `pictures` holds them by time until they are shown.
const pictures = new Map, cores = navigator.hardwareConcurrency || 2
// count: number of tracers; idle: tracers without a picture; spare: free buffers; lit: number of tracers with the hall's
// light; solved: progress of the solver, 0 .. 1; unlit: why the hall has no light; poster: shown while the film does not
// play
let count, w, h, tracers = [], solver, idle, spare = [], lit, solved, unlit, poster
const kNow = 0, kLater = 1, kNever = 2 // when a picture can be traced: Traceable of page_player.h
let turn = 0, shown = 0, skipped = 0, first = 0 // turn: number of seeks; first: when the first picture was shown
const startWorker = (receive, ...first) => {
  const k = new Worker(url)
  const broken = k.onerror = e => k == solver ? leaveOut(reason(e)) : stop(e)
  k.onmessage = own(({ data }) => data.wrong ? broken(data.wrong) : receive(data, k))
  k.postMessage(first)
  return k
}
// Returns the number of workers, 2 to n, that this machine can run at once. WebKit reports four processors even if
// there are two, and pictures of waiting workers come late. Alone a worker may be 15 % faster than with others. Other
// programs only ever make it less, so the best of three counts
const measureWorkers = async n => {
  const spin = k => new Promise((done, fail) => {
    k.onmessage = e => done(e.data[0]), k.onerror = fail, k.postMessage(['spin', 50])
  })
  const all = Array.from({ length: n }, () => new Worker(url)), together = async () =>
    (await Promise.all(all.map(spin))).reduce((a, b) => a + b)
  await together() // compiles the loop
  const one = await spin(all[0]), best = Math.max(await together(), await together(), await together())
  for (const k of all) k.terminate()
  return Math.min(n, Math.max(2, Math.round(1.15 * best / one)))
}
const paint = rgba => draw.putImageData(new ImageData(new Uint8ClampedArray(rgba.buffer), w, h), 0, 0)
const forget = (time, rgba) => { spare.push(rgba), pictures.delete(time) }
// Plans pictures from `from` on, and forgets all that were planned before
const beginPictures = () => {
  pictures.forEach((rgba, time) => forget(time, rgba))
  x.begin(from, w, h, count)
}
const assign = () => {
  for (let at; idle.length && !over && (at = x.plan(filmAt())); ) {
    const [time, level, width, height] = new Float64Array(x.memory.buffer, at, 4), rgba = spare.pop()
    idle.pop().postMessage(['picture', { turn, time, level, width, height }, rgba], rgba ? [rgba.buffer] : [])
  }
}
// Passes the hall's light on to the next worker. The message is moved, not copied
const light = hall => {
  const to = tracers[lit++] ?? solver
  to.postMessage(['light', hall], [hall.pages.buffer])
  if (lit == count) x.hall(kNow), release('hall'), assign()
}
const leaveOut = why => {
  unlit = `The light of the hall could not be solved (${why}): its scenes are left out.`
  x.hall(kNever), release('hall'), assign()
}
const receiveFromTracer = (d, k) => {
  if (d.hall) return light(d.hall)
  if (d.still) return poster = d.rgba, playing || paint(poster)
  if (d.turn == turn) {
    x.traced(d.time, d.trace / 1e3, d.samples, d.width)
    pictures.set(d.time, d.rgba)
  } else if (d.rgba)
    spare.push(d.rgba)
  idle.push(k), assign()
}
// Shows the picture that is due when the film is at `film`, and forgets it and all earlier ones
const showDue = (film, t) => {
  const due = x.due(film)
  if (due < 0) return
  paint(pictures.get(due))
  if (!shown++) first = now()
  x.shown(film - from, now() - t)
  for (const [time, rgba] of pictures)
    if (time <= due) skipped += time < due, forget(time, rgba)
}
// Starts the workers. Pictures have the screen's size, which is known before the click, so the workers start early. In
// a page that does not fill the screen, pictures have the page's size; if it has changed at the click, workers restart
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
  idle = [], unlit = poster = null, lit = solved = 0
  x.hall(kLater), beginPictures()
  spare = []
  tracers = Array.from({ length: count }, () => startWorker(receiveFromTracer, 'trace', module, w, h))
  tracers[0].postMessage(['picture', { time: 35, level: 1, width: 0, height: 0, still: 1 }])
  solver = startWorker(d => {
    if (d.progress) solved = d.progress
    if (d.hall) solver.terminate(), light(d.hall)
  }, 'solve', module, w, h)
}
