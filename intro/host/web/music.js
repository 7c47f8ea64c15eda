// Music: a worker composes it ten seconds ahead, so that it plays on even if the machine is busy.
const kChunk = 100, chunkSeconds = () => kChunk * x.block() / x.rate() // a chunk of music: 100 blocks
const kComposed = 10, kFirst = 2 // seconds to compose ahead, and before the click
// zero: when the music begins, on the clock of `audio`; asked, scheduled: numbers of chunks; waiting: chunks to
// schedule; settled: before this moment (milliseconds) the sound sets the film's clock, later it only corrects it;
// heard: the time of `audio` at the last refresh; moved: when that changed. After a stop, or if it is far off, the
// sound sets the clock again
let composer, audio, gain, zero, silent, asked = 0, scheduled = 0, settled = 0, heard, moved = 0, waiting = []
const startComposer = () => composer = startWorker(d => {
  if (d.turn == turn) waiting.push(d), schedule()
}, 'compose', module, blockAt(from), turn)
const blockAt = time => Math.round(time * x.rate() / x.block())
const openSound = () => {
  try {
    audio = new AudioContext({ sampleRate: x.rate() })
    audio.resume()
    connect()
  } catch { silent = 1 }
}
// Connects a new output, and silences what was scheduled before
const connect = () => {
  const before = gain
  before?.disconnect()
  gain = audio.createGain()
  if (before) gain.gain.value = before.gain.value
  gain.connect(audio.destination)
}
const seekMusic = () => {
  asked = scheduled = 0, zero = null, waiting = []
  composer.postMessage(['seek', blockAt(from), turn])
  if (audio) connect(), audio.resume()
}
const compose = () => {
  const most = playing ? kComposed + Math.max(0, filmAt() - from) : kFirst
  for (; !silent && asked * chunkSeconds() < most; ++asked) composer.postMessage(['sound', kChunk])
}
const schedule = () => {
  while (zero != null && waiting.length) {
    const s = audio.createBufferSource(), when = zero + scheduled++ * chunkSeconds()
    const late = Math.max(0, audio.currentTime + 0.02 - when)
    const { left, right } = waiting.shift()
    const buffer = audio.createBuffer(2, left.length, x.rate())
    buffer.copyToChannel(left, 0), buffer.copyToChannel(right, 1)
    s.buffer = buffer // Firefox plays the samples that it has now
    s.connect(gain)
    if (late < chunkSeconds()) s.start(when + late, late)
  }
}
// The film's time that is heard at t milliseconds
const heardAt = t => {
  const { contextTime, performanceTime } = audio.getOutputTimestamp?.() ?? {}
  // WebKitGTK 2.50 adds the context's time to the page's
  return from - zero + (contextTime > 0 && performanceTime < now() + 50 ? contextTime + (t - performanceTime) / 1e3
    : audio.currentTime - (audio.outputLatency || 0))
}
