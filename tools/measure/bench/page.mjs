// node page.mjs times chromium|firefox PAGE SECONDS...: what a picture of 1280x720 takes one worker, in `draft`: CSV
// node page.mjs unpack PAGE: the seconds of processor time that its decoder takes: the least of three, in node
// node page.mjs play chromium|firefox PAGE [QUERY]: opens the page, clicks it, and plays to the end: first what
// `--stats` prints, then a line "page,opens,first,hall,MB before,MB at most": seconds, and memory of the page's
// process. Firefox needs a display.
import { readFileSync, readdirSync } from 'node:fs'
import { inflateRawSync } from 'node:zlib'
import { open, later } from '../../../tests/programs/web/browser.mjs'

const [what, kind, page, ...words] = process.argv.slice(2)
const kWarm = 15, kTimed = 15, kFps = 15
const until = async (b, ready) => {
  for (let i = 0; i < 3000; ++i, await later(100)) if (await b.evaluate(ready)) return
  throw Error(`${kind} never came to ${ready}: ${JSON.stringify(await b.evaluate("self.film?.state()"))}`)
}

// The proportional set size of the process that shows the page, in MB: the largest, since others are kept in reserve
const memory = child => {
  const parents = new Map, shows = new Set
  for (const id of readdirSync('/proc').filter(id => +id))
    try {
      parents.set(id, readFileSync(`/proc/${id}/stat`, 'utf8').replace(/.*\) . /, '').split(' ')[0])
      if (/--type=renderer|contentproc.*\btab\b/.test(readFileSync(`/proc/${id}/cmdline`, 'latin1'))) shows.add(id)
    } catch {} // it has ended
  const below = id => id == child.pid || parents.has(id) && below(parents.get(id))
  const kib = [...shows].filter(below).map(id =>
    +readFileSync(`/proc/${id}/smaps_rollup`, 'utf8').match(/^Pss: +(\d+)/m)[1])
  return Math.round(Math.max(...kib) / 1024)
}

// As the page's loader does it, whose script has the numbers
const unpack = async page => {
  const file = readFileSync(page), text = file.toString('latin1'), script = text.slice(text.indexOf('<script>'))
  const [count, key, model, head] = ['length<(\\d+)', '\\)\\^(\\d+)', 'slice\\(0,(\\d+)\\),i', 'o\\.slice\\(0,(\\d+)']
    .map(what => +script.match(what)[1])
  const coded = new Uint8Array(count)
  for (let i = text.indexOf('<!--') + 4, n = 0; n < count; ++n) {
    const c = file[i++]
    coded[n] = (c == 1 ? file[i++] ^ 64 : c) ^ key
  }
  const decoder = inflateRawSync(coded.slice(0, head)), { exports } =
    (await WebAssembly.instantiate(decoder.slice(model))).instance, bytes = new Uint8Array(exports.memory.buffer)
  bytes.set(decoder.slice(0, model), exports.i()), bytes.set(coded.slice(head), exports.i() + model)
  const before = process.cpuUsage()
  exports.d()
  const { user, system } = process.cpuUsage(before)
  return (user + system) / 1e6
}
if (what == 'unpack') {
  const times = []
  for (let i = 0; i < 3; ++i) times.push(await unpack(kind))
  console.log(Math.min(...times).toFixed(2))
  process.exit()
}

const b = await open(kind, `file://${page}?full=0&stats${words[0]?.startsWith('&') ? words[0] : ''}`)
const began = performance.now()
try {
  await until(b, 'self.film && document.querySelector("b").textContent')
  const opens = performance.now() - began
  if (what == 'times') {
    await until(b, 'film.state().hall')
    for (const t of words) {
      const times = await b.evaluate(`(async () => {
        const times = []
        let heard
        const k = film.start(d => heard(d), 'trace', film.module, 1280, 720)
        const asked = (...all) => new Promise(done => {
          heard = done
          if (all.length) k.postMessage(all)
        })
        await asked()
        if (${t} > 63) {
          self.hall ??= await new Promise((done, fail) =>
            film.start(d => d.hall ? done(d.hall) : d.wrong && fail(d.wrong), 'solve', film.module, 1280, 720))
          self.hall = (await asked('light', self.hall)).hall
        }
        for (let i = 0; i < ${kWarm + kTimed}; ++i) {
          const t = performance.now()
          await asked('picture', { time: ${t} + i / ${kFps}, level: 2, width: 0, height: 0 })
          times.push(performance.now() - t)
        }
        k.terminate()
        return times.slice(${kWarm})
      })()`)
      console.log(`${t},${times.sort((a, b) => a - b)[kTimed >> 1].toFixed(1)}`)
    }
  } else {
    await later(5000)
    const before = memory(b.child)
    await b.click()
    await until(b, 'film.state().shown')
    const { first } = await b.evaluate('film.state()')
    let hall = 0, most = 0
    for (let s; !(s = await b.evaluate('film.state()')).over; await later(1000)) {
      if (s.hall && !hall) hall = s.film
      most = Math.max(most, memory(b.child))
    }
    console.log(await b.evaluate('film.statistics()'))
    console.log(['page', (opens / 1000).toFixed(1), (first / 1000).toFixed(2), hall.toFixed(1), before, most].join())
  }
} finally {
  await b.close()
}
