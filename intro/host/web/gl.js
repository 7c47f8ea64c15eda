// The OpenGL functions that hemicubes use, on WebGL 2. makeGl(context, () => ArrayBuffer) returns them by name.
const makeGl = (gl, memory) => {
  const objects = [null], name = object => objects.push(object) - 1
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
      gl.shaderSource(objects[s], view(Uint32Array, from, n).reduce((all, at) => all + text(at), '').replace('330', es)),
    glGetProgramiv: (p, what, to) => { view(Int32Array, to, 1)[0] = +gl.getProgramParameter(objects[p], what) },
    glGetUniformLocation: (p, at) => name(gl.getUniformLocation(objects[p], text(at))),
    glUniform1fv: (u, n, at) => gl.uniform1fv(objects[u], view(Float32Array, at, n)),
    glBufferData: (to, n, from, use) => gl.bufferData(to, view(Uint8Array, from, n), use),
    glClearBufferuiv: (what, i, at) => gl.clearBufferuiv(what, i, view(Uint32Array, at, 4)),
    glClearBufferfv: (what, i, at) => gl.clearBufferfv(what, i, view(Float32Array, at, 1)),
    glReadPixels: (x, y, w, h, format, type, to) => {
      const out = view(Uint32Array, to, w * h)
      if (gl.getParameter(0x8b9b) == format) return gl.readPixels(x, y, w, h, format, type, out)
      const four = new Uint32Array(w * h * 4) // some browsers cannot read red alone; all can read four channels
      gl.readPixels(x, y, w, h, 0x8d99, type, four)
      for (let i = 0; i < w * h; ++i) out[i] = four[4 * i]
    },
  }
  // The other functions take numbers (n) or names of objects (o)
  const names = { BindFramebuffer: 'no', BindRenderbuffer: 'no', FramebufferRenderbuffer: 'nnno', CompileShader: 'o',
    AttachShader: 'oo', LinkProgram: 'o', UseProgram: 'o', BindVertexArray: 'o', BindBuffer: 'no' }
  return new Proxy(f, {
    get: (f, key) => f[key] ??= (short => (...all) =>
      gl[short[0].toLowerCase() + short.slice(1)](...all.map((a, i) => names[short]?.[i] == 'o' ? objects[a] : a))
    )(key.slice(2))
  })
}
