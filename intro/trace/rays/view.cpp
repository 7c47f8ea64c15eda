#include "trace/rays/view.h"

#include "base/maths.h"

namespace odraz {

View lookAt(const Vec3 &eye, const Vec3 &target, float roll, float fov, int width, int height) {
    View view = {};
    view.eye = eye;
    view.width = (float)width;
    view.height = (float)height;
    // Build the frame, with a substitute for each direction that is zero
    Vec3 forward = normalize(target - eye);
    if (dot(forward, forward) < 0.5f) forward = {0, 0, -1};
    Vec3 right = cross(forward, Vec3{0, 1, 0});
    if (dot(right, right) < 1e-10f) right = {1, 0, 0};
    right = normalize(right);
    Vec3 up = cross(right, forward);
    float angle = roll * (kPi / 180);
    float c = cos(angle), s = sin(angle);
    Vec3 rolledRight = right * c - up * s;
    Vec3 rolledUp = up * c + right * s;
    // Scale it to the field of view
    float half = clamp(fov, 0.01f, 170.f) * (kPi / 360);
    float tall = 2 * sin(half) / cos(half);
    view.forward = forward;
    view.right = rolledRight * (tall * (float)width / (float)height);
    view.down = rolledUp * -tall;
    view.spread = tall / (float)height;
    return view;
}

} // namespace odraz
