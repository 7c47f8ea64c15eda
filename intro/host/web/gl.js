// OpenGL's functions as hemicubes use them, on WebGL 2: makeGl(context, () => ArrayBuffer) -> functions by name.
const makeGl = (gl, memory) => {
  const things = [null], name = thing => things.push(thing) - 1
  const es = '300 es\nprecision highp float;precision highp int;'
  const view = (T, at, n) => new T(memory(), at, n)
  const text = at => {
    const b = new Uint8Array(memory(), at)
    return String.fromCharCode(...b.subarray(0, b.indexOf(0)))
  }
  const generate = make => (n, to) => view(Uint32Array, to, n).forEach((_, i, v) => v[i] = name(make()))
  const f = {
    glGenFramebuffers: generate(() => gl.createFramebuffer()),
    glGenRenderbuffers: generate(() => gl.createRenderbuffer()),
    glGenVertexArrays: generate(() => gl.createVertexArray()),
    glGenBuffers: generate(() => gl.createBuffer()),
    glCreateProgram: () => name(gl.createProgram()),
    glCreateShader: kind => name(gl.createShader(kind)),
    glShaderSource: (s, n, from) =>
      gl.shaderSource(things[s], view(Uint32Array, from, n).reduce((all, at) => all + text(at), '').replace('330', es)),
    glGetProgramiv: (p, what, to) => { view(Int32Array, to, 1)[0] = +gl.getProgramParameter(things[p], what) },
    glGetUniformLocation: (p, at) => name(gl.getUniformLocation(things[p], text(at))),
    glUniform1fv: (u, n, at) => gl.uniform1fv(things[u], view(Float32Array, at, n)),
    glBufferData: (to, n, from, use) => gl.bufferData(to, view(Uint8Array, from, n), use),
    glClearBufferuiv: (what, i, at) => gl.clearBufferuiv(what, i, view(Uint32Array, at, 4)),
    glClearBufferfv: (what, i, at) => gl.clearBufferfv(what, i, view(Float32Array, at, 1)),
    glReadPixels: (x, y, w, h, format, type, to) => {
      const out = view(Uint32Array, to, w * h)
      if (gl.getParameter(0x8b9b) == format) return gl.readPixels(x, y, w, h, format, type, out)
      const four = new Uint32Array(w * h * 4) // some give red alone, all give it among four
      gl.readPixels(x, y, w, h, 0x8d99, type, four)
      for (let i = 0; i < w * h; ++i) out[i] = four[4 * i]
    },
  }
  // The others take numbers, and names (o) of things
  const names = { BindFramebuffer: 'no', BindRenderbuffer: 'no', FramebufferRenderbuffer: 'nnno', CompileShader: 'o',
    AttachShader: 'oo', LinkProgram: 'o', UseProgram: 'o', BindVertexArray: 'o', BindBuffer: 'no' }
  return new Proxy(f, {
    get: (f, key) => f[key] ??= (short => (...all) =>
      gl[short[0].toLowerCase() + short.slice(1)](...all.map((a, i) => names[short]?.[i] == 'o' ? things[a] : a))
    )(key.slice(2))
  })
}
