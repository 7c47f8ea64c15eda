// Music: a worker composes it, and it is scheduled ten seconds ahead, so that it goes on whatever the machine does.
const kRate = 48000, kBlock = 240, kChunk = 100, seconds = kChunk * kBlock / kRate // a chunk: so many blocks, which last so long
const kComposed = 10, kFirst = 2 // seconds ahead, and those before the click
let composer, audio, gain, zero, silent, asked = 0, scheduled = 0, settled = 0, waiting = []
const startComposer = () => composer = startWorker(d => {
  if (d.turn == turn) waiting.push(d), schedule()
}, 'compose', module, blockAt(from), turn)
const blockAt = time => Math.round(time * kRate / kBlock)
const openSound = () => {
  try {
    audio = new AudioContext({ sampleRate: kRate })
    audio.resume()
    connect()
  } catch { silent = 1 }
}
// What is scheduled is heard no more
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
  if (!silent) connect(), audio.resume()
}
const compose = () => {
  const most = playing ? kComposed + Math.max(0, filmAt() - from) : kFirst
  for (; !silent && asked * seconds < most; ++asked) composer.postMessage(['sound', kChunk])
}
const schedule = () => {
  while (zero != null && waiting.length) {
    const s = audio.createBufferSource(), when = zero + scheduled++ * seconds
    const late = Math.max(0, audio.currentTime + 0.02 - when)
    const { left, right } = waiting.shift()
    s.buffer = audio.createBuffer(2, left.length, kRate)
    s.buffer.copyToChannel(left, 0), s.buffer.copyToChannel(right, 1)
    s.connect(gain)
    if (late < seconds) s.start(when + late, late)
  }
}
// The film's time that is heard now
const heardAt = t => {
  const { contextTime, performanceTime } = audio.getOutputTimestamp?.() ?? {}
  return from - zero + (contextTime > 0 ? contextTime + (t - performanceTime) / 1e3
    : audio.currentTime - (audio.outputLatency || 0))
}
