// node page.mjs times chromium|firefox PAGE SECONDS...: what a picture of 1280x720 takes one worker, in `draft`: a CSV
// node page.mjs play chromium|firefox PAGE LENGTH SECONDS...: opens the page, clicks it, and plays so many seconds from
// each of these: what `--stats` prints, then a line "page,opens,first,MB before,MB at most": seconds, and memory of the
// page's process. Firefox needs a display.
import { readFileSync, readdirSync } from 'node:fs'
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

// use(browser, seconds until the page is there)
const opened = async (query, use) => {
  const began = performance.now(), b = await open(kind, `file://${page}?full=0&stats${query}`)
  try {
    await until(b, 'self.film && document.querySelector("b").textContent')
    await use(b, (performance.now() - began) / 1e3)
  } finally {
    await b.close()
  }
}

// The median time of a picture, in the page: one worker, which has made some before
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
    await until(b, 'film.state().hall') // which would take the processors meanwhile
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
      for (let s; !(s = await b.evaluate('film.state()')).over && s.film < end; await later(500))
        most = Math.max(most, memory(b.child))
      console.log(await b.evaluate('film.statistics()'))
      console.log(['page', opens.toFixed(2), (first / 1000).toFixed(2), before, most].join())
    })
