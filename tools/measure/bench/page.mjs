// node page.mjs times BROWSER PAGE SECOND...: prints the time of a picture of 1280x720 in `draft` on one worker, as a
// CSV. BROWSER: chromium, firefox or webkit.
// node page.mjs play BROWSER PAGE LENGTH SECOND...: opens the page, clicks it, and plays LENGTH seconds from each
// SECOND. Prints the table of `--stats`, then a line "page,opens,first,MB before,MB at most": the seconds until
// the page is ready and from the click to the first picture, and the memory of the page's process.
// Firefox and WebKit need a display.
import { readFileSync, readdirSync } from 'node:fs'
import { open, later } from '../../../tests/programs/web/browser.mjs'

const [what, kind, page, ...words] = process.argv.slice(2)
const kWarm = 15, kTimed = 15, kFps = 15
const until = async (b, ready) => {
  for (let i = 0; i < 3000; ++i, await later(100)) if (await b.evaluate(ready)) return
  throw Error(`${kind}: ${ready} is still false after 300 s: ${JSON.stringify(await b.evaluate("self.film?.state()"))}`)
}

// The proportional set size, in MB, of the process that shows the page: the largest one, since the others are spare
const memory = child => {
  const parents = new Map, shows = new Set
  for (const id of readdirSync('/proc').filter(id => +id))
    try {
      parents.set(id, readFileSync(`/proc/${id}/stat`, 'utf8').replace(/.*\) . /, '').split(' ')[0])
      if (/--type=renderer|contentproc.*\btab\b|WebKitWebProcess/.test(readFileSync(`/proc/${id}/cmdline`, 'latin1'))) shows.add(id)
    } catch {} // the process has ended
  const below = id => id == child.pid || parents.has(id) && below(parents.get(id))
  const kib = [...shows].filter(below).map(id =>
    +readFileSync(`/proc/${id}/smaps_rollup`, 'utf8').match(/^Pss: +(\d+)/m)[1])
  return Math.round(Math.max(...kib) / 1024)
}

// Opens the page and calls use(browser, seconds until the page is ready)
const opened = async (query, use) => {
  const began = performance.now(), b = await open(kind, `file://${page}?full=0&stats${query}`)
  try {
    await until(b, 'self.film && document.querySelector("button").textContent')
    await use(b, (performance.now() - began) / 1e3)
  } finally {
    await b.close()
  }
}

// Runs in the page: the median time of a picture on one worker that has already made `warm` pictures
const traced = async (t, warm, timed, fps) => {
  const times = []
  let heard
  const k = film.start(d => heard(d), 'trace', film.module, 1280, 720)
  const asked = (...all) => new Promise(done => {
    heard = done
    if (all.length) k.postMessage(all)
  })
  await asked()
  for (let i = 0; i < warm + timed; ++i) {
    const began = performance.now()
    await asked('picture', { time: t + i / fps, level: 2, width: 0, height: 0 })
    times.push(performance.now() - began)
  }
  k.terminate()
  return times.slice(warm).sort((a, b) => a - b)[timed >> 1]
}

if (what == 'times')
  await opened('', async b => {
    await until(b, 'film.state().hall') // solving the hall would disturb the times
    console.log('second,ms')
    for (const t of words)
      console.log(`${t},${(await b.evaluate(`(${traced})(${t}, ${kWarm}, ${kTimed}, ${kFps})`)).toFixed(1)}`)
  })
else
  for (const from of words.slice(1))
    await opened('&from=' + from, async (b, opens) => {
      const before = memory(b.child)
      await b.click()
      await until(b, 'film.state().shown')
      const { first } = await b.evaluate('film.state()'), end = +from + +words[0]
      let most = before
      for (let s; (s = await b.evaluate('film.state()')).playing && s.film < end; await later(500))
        most = Math.max(most, memory(b.child))
      console.log(await b.evaluate('film.statistics()'))
      console.log(['page', opens.toFixed(2), (first / 1000).toFixed(2), before, most].join())
    })
