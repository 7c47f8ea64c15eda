#include "maker/panel/input.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace odraz::maker {

namespace {

// For GLFW's callbacks
Panel *thePanel;
GLFWkeyfun theKeys;
double theX, theY; // from the last motion event: the mouse may have moved on when a button's event is handled

void toPicture(GLFWwindow *window, double &x, double &y) {
    int w, h;
    glfwGetWindowSize(window, &w, &h);
    x *= (double)thePanel->pictureWidth() / (w > 0 ? w : 1);
    y *= (double)thePanel->pictureHeight() / (h > 0 ? h : 1);
}

int keyOf(int key) {
    return key == GLFW_KEY_TAB         ? code(KeyName::Tab)
           : key == GLFW_KEY_PAGE_UP   ? code(KeyName::PageUp)
           : key == GLFW_KEY_PAGE_DOWN ? code(KeyName::PageDown)
                                       : key; // printable keys have the codes of their characters
}

bool repeats(Action action) { return action >= Action::PictureBack && action <= Action::EventOn; }

void onKey(GLFWwindow *window, int key, int scancode, int action, int mods) {
    Action wanted = mods & GLFW_MOD_CONTROL ? Action::Count : actionOf(keyOf(key), mods & GLFW_MOD_SHIFT);
    if (wanted == Action::Count) {
        if (theKeys) theKeys(window, key, scancode, action, mods);
    } else if (action == GLFW_PRESS || (action == GLFW_REPEAT && repeats(wanted))) {
        thePanel->act(wanted);
    }
}

void onButton(GLFWwindow *, int button, int action, int mods) {
    if (action == GLFW_RELEASE) return thePanel->release();
    bool right = button == GLFW_MOUSE_BUTTON_RIGHT || (mods & GLFW_MOD_SHIFT);
    thePanel->press(theX, theY, right ? Panel::Button::Right : Panel::Button::Left);
}

void onMove(GLFWwindow *window, double x, double y) {
    toPicture(window, x, y);
    theX = x, theY = y;
    thePanel->move(x, y);
}

void onWheel(GLFWwindow *, double, double turns) { thePanel->wheel(theX, theY, turns); }

} // namespace

void listen(Panel &panel, GLFWwindow *window) {
    thePanel = &panel;
    glfwGetCursorPos(window, &theX, &theY);
    toPicture(window, theX, theY);
    theKeys = glfwSetKeyCallback(window, onKey);
    glfwSetMouseButtonCallback(window, onButton);
    glfwSetCursorPosCallback(window, onMove);
    glfwSetScrollCallback(window, onWheel);
}

} // namespace odraz::maker
