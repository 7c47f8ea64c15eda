// A browser under test, without WebGL: open('chromium' | 'firefox' | 'webkit', url) -> { evaluate(text), click(),
// key(name), resize(w, h), screenshot(file), close(), errors }. Chromium is controlled by pipes, Firefox by a port
// (Marionette), and WebKit (WebKitGTK's MiniBrowser) by WebDriver.
import { spawn } from 'node:child_process'
import { once } from 'node:events'
import { mkdtempSync, writeFileSync, readFileSync, rmSync } from 'node:fs'
import { request } from 'node:http'
import { connect, createServer } from 'node:net'
import { tmpdir } from 'node:os'

const later = ms => new Promise(r => setTimeout(r, ms))
const kWidth = 1280, kHeight = 720
process.on('SIGTERM', () => process.exit(1)) // ends the browsers, too

const chromium = async (url, profile) => {
  const child = spawn('chromium', ['--headless=new', '--no-sandbox', '--user-data-dir=' + profile, '--no-first-run',
    '--remote-debugging-pipe', '--disable-background-networking', '--disable-gpu', '--disable-software-rasterizer',
    '--autoplay-policy=user-gesture-required', `--window-size=${kWidth},${kHeight}`, 'about:blank'],
    { stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'] })
  process.on('exit', () => child.kill())
  const waiting = new Map, errors = []
  const message = details => details.exception?.description ?? details.text
  let rest = '', id = 0, session
  child.stdio[4].on('data', data => {
    const parts = (rest + data).split('\0')
    rest = parts.pop()
    for (const m of parts.map(p => JSON.parse(p))) {
      if (m.id) waiting.get(m.id)(m)
      else if (m.method == 'Runtime.exceptionThrown') errors.push(message(m.params.exceptionDetails))
      else if (m.method == 'Log.entryAdded' && m.params.entry.level == 'error') errors.push(m.params.entry.text)
      else if (m.method == 'Runtime.consoleAPICalled' && m.params.type == 'error')
        errors.push(m.params.args.map(a => a.value ?? a.description).join(' '))
    }
  })
  const call = (method, params = {}) => new Promise((done, fail) => {
    waiting.set(++id, m => m.error ? fail(Error(method + ': ' + m.error.message)) : done(m.result))
    child.stdio[3].write(JSON.stringify({ id, method, params, sessionId: session }) + '\0')
  })
  const { targetInfos } = await call('Target.getTargets')
  const targetId = targetInfos.find(t => t.type == 'page').targetId
  session = (await call('Target.attachToTarget', { targetId, flatten: true })).sessionId
  for (const domain of ['Runtime', 'Log', 'Page']) await call(domain + '.enable')
  await call('Page.navigate', { url })
  return {
    child, errors,
    async evaluate(expression) {
      const how = { expression: `(async () => (${expression}))()`, awaitPromise: true, returnByValue: true }
      const r = await call('Runtime.evaluate', how)
      if (r.exceptionDetails) throw Error(message(r.exceptionDetails))
      return r.result.value
    },
    async click() {
      for (const type of ['mousePressed', 'mouseReleased'])
        await call('Input.dispatchMouseEvent', { type, x: 900, y: 200, button: 'left', clickCount: 1 })
    },
    async key(key) { for (const type of ['keyDown', 'keyUp']) await call('Input.dispatchKeyEvent', { type, key }) },
    resize: (width, height) =>
      call('Emulation.setDeviceMetricsOverride', { width, height, deviceScaleFactor: 1, mobile: false }),
    async screenshot(file) {
      writeFileSync(file, Buffer.from((await call('Page.captureScreenshot')).data, 'base64'))
    },
  }
}

// For browsers whose protocol is like WebDriver's
const awaited = expression => `const done = arguments[arguments.length - 1]
  ;(async () => (${expression}))().then(v => [v], e => [null, e + ' ' + e.stack])
    .then(([v, wrong]) => done([v, wrong, self.errors]))`
const result = ([value, wrong]) => {
  if (wrong) throw Error(wrong)
  return value
}
const kMove = { type: 'pointerMove', x: 900, y: 200 }
const kClick = [kMove, ...['pointerDown', 'pointerUp'].map(type => ({ type, button: 0 }))]
const kArrows = { ArrowLeft: '\ue012', ArrowRight: '\ue014' }
const pressed = name => ['keyDown', 'keyUp'].map(type => ({ type, value: kArrows[name] ?? name }))

const firefox = async (url, profile) => {
  const prefs = { 'webgl.disabled': true, 'media.autoplay.blocking_policy': 0, 'marionette.port': 0,
    'datareporting.policy.dataSubmissionEnabled': false, 'browser.shell.checkDefaultBrowser': false,
    'browser.aboutwelcome.enabled': false, 'devtools.console.stdout.content': true }
  writeFileSync(profile + '/user.js', Object.entries(prefs).map(([k, v]) => `user_pref("${k}", ${v});\n`).join(''))
  const words = ['--no-remote', '--marionette', '--profile', profile, '--width', kWidth, '--height', kHeight]
  // No sound: in one of five starts Firefox waits for PulseAudio without end when a page opens its sound
  const env = { ...process.env, PULSE_SERVER: 'unix:/none' }
  const child = spawn('firefox-esr', words, { stdio: ['ignore', 'pipe', 'pipe'], env })
  process.on('exit', () => child.kill())
  const errors = []
  let printed = '', port
  for (const out of [child.stdout, child.stderr]) out.on('data', d => {
    printed += d
    for (const line of String(d).split('\n'))
      if (/^(JavaScript error|console\.error)/.test(line) && /odraz|blob:/.test(line)) errors.push(line)
  })
  for (let i = 0; i < 9000 && !port; ++i) {
    await later(100)
    try { port = +readFileSync(profile + '/MarionetteActivePort', 'utf8') } catch {}
  }
  if (!port) throw Error('Firefox does not listen: ' + printed)
  const socket = connect(port, '127.0.0.1'), waiting = new Map
  let rest = Buffer.alloc(0), id = 0
  socket.on('data', data => {
    for (rest = Buffer.concat([rest, data]); ;) {
      const colon = rest.indexOf(58), size = +rest.subarray(0, colon)
      if (colon < 0 || rest.length < colon + 1 + size) return
      const m = JSON.parse(rest.subarray(colon + 1, colon + 1 + size))
      rest = rest.subarray(colon + 1 + size)
      if (Array.isArray(m)) waiting.get(m[1])(m)
    }
  })
  const call = (name, params = {}) => new Promise((done, fail) => {
    waiting.set(++id, m => m[2] ? fail(Error(name + ': ' + m[2].message)) : done(m[3]))
    const text = JSON.stringify([0, id, name, params])
    socket.write(Buffer.byteLength(text) + ':' + text)
  })
  const act = (type, actions) => call('WebDriver:PerformActions', { actions: [{ type, id: type, actions }] })
  await call('WebDriver:NewSession')
  await call('WebDriver:SetTimeouts', { script: 3600000, pageLoad: 3600000 })
  await call('WebDriver:Navigate', { url })
  return {
    child, errors,
    async evaluate(expression) {
      const how = { script: awaited(expression), args: [], sandbox: null, newSandbox: false }
      return result((await call('WebDriver:ExecuteAsyncScript', how)).value)
    },
    click: () => act('pointer', kClick),
    key: name => act('key', pressed(name)),
    resize: (width, height) => call('WebDriver:SetWindowRect', { width, height }),
    async screenshot(file) {
      writeFileSync(file, Buffer.from((await call('WebDriver:TakeScreenshot', { full: false })).value, 'base64'))
    },
  }
}

// Runs in the page: collects its errors, since the driver discards what the browser prints
const collect = () => self.errors ??= (errors => {
  addEventListener('error', e => errors.push(e.message))
  addEventListener('unhandledrejection', e => errors.push(String(e.reason)))
  console.error = (...all) => errors.push(all.join(' '))
  return errors
})([])

const webkit = async (url, profile) => {
  const free = createServer().listen(0, '127.0.0.1')
  await once(free, 'listening')
  const { port } = free.address()
  free.close()
  // Driver and browser are a group of processes, so that they end together
  const env = { ...process.env, XDG_DATA_HOME: profile, XDG_CACHE_HOME: profile, XDG_CONFIG_HOME: profile }
  const child = spawn('WebKitWebDriver', ['--port=' + port], { stdio: 'ignore', detached: true, env })
  child.kill = () => { try { process.kill(-child.pid, 'SIGKILL') } catch {} }
  process.on('exit', child.kill)
  const call = (path, body) => new Promise((done, fail) => {
    const options = { host: '127.0.0.1', port, path, method: body ? 'POST' : 'GET' }
    request(options, async answer => {
      let text = ''
      for await (const part of answer) text += part
      const { value } = JSON.parse(text)
      value?.error ? fail(Error(`${path}: ${value.error}: ${value.message}`)) : done(value)
    }).on('error', fail).end(body && JSON.stringify(body))
  })
  for (let i = 0; ; ++i, await later(100)) {
    const status = await call('/status').catch(() => 0)
    if (status.ready) break
    if (i > 9000 || child.exitCode != null) throw Error('WebKitWebDriver does not listen')
  }
  const session = '/session/' + (await call('/session', { capabilities: {} })).sessionId
  const ask = (what, body) => call(`${session}/${what}`, body)
  const act = (type, actions) => ask('actions', { actions: [{ type, id: type, actions }] })
  const resize = (width, height) => ask('window/rect', { width, height })
  const errors = []
  const evaluate = async expression => {
    const all = await ask('execute/async', { script: awaited(`(${collect})(), ${expression}`), args: [] })
    errors.splice(0, Infinity, ...all[2])
    return result(all)
  }
  await ask('timeouts', { script: 3600000, pageLoad: 3600000 })
  await resize(kWidth, kHeight)
  await ask('url', { url })
  await evaluate('0')
  return {
    child, errors, evaluate, resize,
    click: () => act('pointer', kClick),
    key: name => act('key', pressed(name)),
    async screenshot(file) { writeFileSync(file, Buffer.from(await ask('screenshot'), 'base64')) },
  }
}

export const open = async (kind, url) => {
  const profile = mkdtempSync(tmpdir() + '/odraz-browser-')
  const browser = await { chromium, firefox, webkit }[kind](url, profile)
  const ended = new Promise(r => browser.child.on('exit', r))
  browser.close = async () => {
    browser.child.kill()
    await ended
    // Its other processes may still write into the profile
    try { rmSync(profile, { recursive: true, maxRetries: 20, retryDelay: 100 }) } catch {}
  }
  return browser
}
export { later }
