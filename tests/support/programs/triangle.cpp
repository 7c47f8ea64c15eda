// An SDL2 window with a triangle drawn by OpenGL. With an argument N it ends after N pictures and prints the
// colour in the middle.
#include <SDL2/SDL.h>
#include <SDL2/SDL_opengl.h>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

static void draw() {
    glClear(GL_COLOR_BUFFER_BIT);
    glBegin(GL_TRIANGLES);
    for (int k = 0; k < 3; ++k) {
        glColor3f(k == 0, k == 1, k == 2);
        glVertex2f(k == 0 ? 0 : k == 1 ? -0.9f : 0.9f, k == 0 ? 1 : -0.5f);
    }
    glEnd();
}

int main(int count, char **words) {
    try {
        if (SDL_Init(SDL_INIT_VIDEO)) throw std::runtime_error(SDL_GetError());
        SDL_Window *window = SDL_CreateWindow("triangle", 0, 0, 320, 240, SDL_WINDOW_OPENGL);
        if (!window || !SDL_GL_CreateContext(window)) throw std::runtime_error(SDL_GetError());
        for (int left = count > 1 ? std::atoi(words[1]) : 1; left--; SDL_GL_SwapWindow(window)) draw();
        draw();
        unsigned char middle[4];
        glReadPixels(160, 120, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, middle);
        std::printf("%d %d %d\n", middle[0], middle[1], middle[2]);
        SDL_Quit();
    } catch (const std::exception &e) {
        std::fprintf(stderr, "triangle: %s\n", e.what());
        return 1;
    }
}
