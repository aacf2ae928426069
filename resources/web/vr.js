// A headset: the panel stands before the viewer as a rectangle with what each eye sees of it.
'use strict';

// The product of matrices of 16 numbers, in columns.
function product(a, b) {
  const result = new Float32Array(16);
  for (let column = 0; column < 4; ++column)
    for (let row = 0; row < 4; ++row)
      for (let k = 0; k < 4; ++k) result[4 * column + row] += a[4 * k + row] * b[4 * column + k];
  return result;
}

// What draws a textured rectangle of size width × height around a centre.
function rectangleIn(gl) {
  const program = gl.createProgram();
  for (const [type, text] of [
    [gl.VERTEX_SHADER, `attribute vec2 at; uniform mat4 view; uniform vec3 centre; uniform vec2 size; varying vec2 place;
      void main() { place = vec2(at.x + 0.5, 0.5 - at.y); gl_Position = view * vec4(at * size + centre.xy, centre.z, 1.0); }`],
    [gl.FRAGMENT_SHADER, `precision mediump float; varying vec2 place; uniform sampler2D light;
      void main() { gl_FragColor = texture2D(light, place); }`]]) {
    const shader = gl.createShader(type);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  gl.bindAttribLocation(program, 0, 'at');
  gl.linkProgram(program);
  gl.useProgram(program);
  gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
  gl.bufferData(gl.ARRAY_BUFFER, new Float32Array([-0.5, -0.5, 0.5, -0.5, -0.5, 0.5, 0.5, 0.5]), gl.STATIC_DRAW);
  gl.enableVertexAttribArray(0);
  gl.vertexAttribPointer(0, 2, gl.FLOAT, false, 0, 0);
  const of = name => gl.getUniformLocation(program, name);
  return (texture, matrix, centre, size) => {
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.uniformMatrix4fv(of('view'), false, matrix);
    gl.uniform3f(of('centre'), ...centre);
    gl.uniform2f(of('size'), ...size);
    gl.drawArrays(gl.TRIANGLE_STRIP, 0, 4);
  };
}

function textureIn(gl) {
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  for (const [name, value] of [[gl.TEXTURE_MIN_FILTER, gl.LINEAR], [gl.TEXTURE_MAG_FILTER, gl.LINEAR],
                               [gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE], [gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE]])
    gl.texParameteri(gl.TEXTURE_2D, name, value);
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, 1, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array([0, 0, 0, 255]));
  return texture;
}

// Shows the panel, `display` of the session, as far before the first head pose as `distance` says.
// panelOf(eye, width, height) promises { rgba }, the panel as an eye in its frame sees it, or nothing
// behind it. The eyes' pictures are those of the newest pose that has been rendered.
async function enterVr(display, distance, panelOf) {
  const xr = await navigator.xr.requestSession('immersive-vr');
  const gl = document.createElement('canvas').getContext('webgl', { xrCompatible: true });
  await gl.makeXRCompatible();
  await xr.updateRenderState({ baseLayer: new XRWebGLLayer(xr, gl) });
  const space = await xr.requestReferenceSpace('local');
  const draw = rectangleIn(gl);
  const longest = 800, factor = longest / Math.max(...display.size);
  const [width, height] = display.size.map(side => Math.max(1, Math.round(side * factor)));
  const textures = [];
  let centre, isRendering = false;
  const renew = async eyes => {
    isRendering = true;
    for (const [k, eye] of eyes.entries()) {
      const { rgba } = await panelOf(eye, width, height);
      gl.bindTexture(gl.TEXTURE_2D, textures[k] ??= textureIn(gl));
      if (rgba) gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, width, height, 0, gl.RGBA, gl.UNSIGNED_BYTE, rgba);
    }
    isRendering = false;
  };
  xr.requestAnimationFrame(function frame(time, now) {
    xr.requestAnimationFrame(frame);
    const pose = now.getViewerPose(space), layer = xr.renderState.baseLayer;
    if (!pose) return;
    const head = pose.transform.position;
    centre ??= [head.x, head.y, head.z - distance];
    if (!isRendering)
      renew(pose.views.map(({ transform: { position: p } }) => [p.x - centre[0], p.y - centre[1], p.z - centre[2]]));
    gl.bindFramebuffer(gl.FRAMEBUFFER, layer.framebuffer);
    gl.clearColor(0.05, 0.05, 0.05, 1);
    gl.clear(gl.COLOR_BUFFER_BIT);
    pose.views.forEach((view, k) => {
      if (!textures[k]) return;
      const port = layer.getViewport(view);
      gl.viewport(port.x, port.y, port.width, port.height);
      draw(textures[k], product(view.projectionMatrix, view.transform.inverse.matrix), centre, display.size);
    });
  });
}
