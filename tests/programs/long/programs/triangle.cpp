// An SDL2 window with a turning triangle drawn by OpenGL, as intros begin. With an argument N it ends after N
// pictures and prints the colour in the middle.
#define GL_GLEXT_PROTOTYPES
#include <SDL2/SDL.h>
#include <SDL2/SDL_opengl.h>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

GLuint shader(GLenum kind, const std::string &text) {
    GLuint s = glCreateShader(kind);
    const char *source = text.c_str();
    glShaderSource(s, 1, &source, nullptr);
    glCompileShader(s);
    GLint fine = 0;
    glGetShaderiv(s, GL_COMPILE_STATUS, &fine);
    if (!fine) {
        std::vector<char> log(1000);
        glGetShaderInfoLog(s, 1000, nullptr, log.data());
        throw std::runtime_error(log.data());
    }
    return s;
}

GLuint program() {
    GLuint p = glCreateProgram();
    glAttachShader(p, shader(GL_VERTEX_SHADER, "#version 120\nuniform float angle; varying vec3 colour;\n"
                                               "void main() { float c = cos(angle), s = sin(angle);\n"
                                               "gl_Position = vec4(mat2(c, s, -s, c) * gl_Vertex.xy, 0, 1);\n"
                                               "colour = gl_Color.rgb; }\n"));
    glAttachShader(
        p, shader(GL_FRAGMENT_SHADER,
                  "#version 120\nvarying vec3 colour;\nvoid main() { gl_FragColor = vec4(colour, 1); }\n"));
    glLinkProgram(p);
    return p;
}

void play(SDL_Window *window, int pictures) {
    glUseProgram(program());
    for (int i = 0; i != pictures; ++i) {
        for (SDL_Event event; SDL_PollEvent(&event);)
            if (event.type == SDL_QUIT || event.type == SDL_KEYDOWN) return;
        glClear(GL_COLOR_BUFFER_BIT);
        glBegin(GL_TRIANGLES);
        for (int k = 0; k < 3; ++k) {
            float angle = 2.0944f * (float)k;
            glColor3f(k == 0, k == 1, k == 2);
            glVertex2f(std::sin(angle), std::cos(angle));
        }
        glEnd();
        glUniform1f(0, (float)i * 0.02f);
        if (i + 1 == pictures) {
            unsigned char middle[4];
            glReadPixels(160, 120, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, middle);
            std::printf("%d %d %d\n", middle[0], middle[1], middle[2]);
        }
        SDL_GL_SwapWindow(window);
    }
}

} // namespace

int main(int count, char **words) {
    try {
        if (SDL_Init(SDL_INIT_VIDEO)) throw std::runtime_error(SDL_GetError());
        SDL_Window *window = SDL_CreateWindow("triangle", 0, 0, 320, 240, SDL_WINDOW_OPENGL);
        if (!window || !SDL_GL_CreateContext(window)) throw std::runtime_error(SDL_GetError());
        play(window, count > 1 ? std::atoi(words[1]) : -1);
        SDL_Quit();
    } catch (const std::exception &e) {
        std::fprintf(stderr, "triangle: %s\n", e.what());
        return 1;
    }
}
