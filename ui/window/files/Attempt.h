// What a person asked for may fail, and the window goes on.
#pragma once

#include <QString>
#include <exception>

namespace umbra {

// Runs `work`; what it throws is given to `fail` as one line for people.
template <class Work, class Fail>
void attempt(const Work& work, const Fail& fail) {
  try {
    work();
  } catch (const std::exception& problem) {
    fail(QString::fromUtf8(problem.what()));
  }
}

}  // namespace umbra
