// Vectors of the plane over any number type.
#pragma once

namespace bezcert {

template <class T>
struct Vector2 {
  T x, y;
};

template <class T>
Vector2<T> operator-(const Vector2<T>& a, const Vector2<T>& b) {
  return {a.x - b.x, a.y - b.y};
}

template <class T>
T cross(const Vector2<T>& a, const Vector2<T>& b) {
  return a.x * b.y - a.y * b.x;
}

template <class T>
T dot(const Vector2<T>& a, const Vector2<T>& b) {
  return a.x * b.x + a.y * b.y;
}

}  // namespace bezcert
