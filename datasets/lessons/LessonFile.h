// Lessons as JSON, for teachers to write.
//
// {"format": "umbrascope-lesson/1",
//  "name": "light-bleeding", "title": "…", "summary": "…", "after": "Lauritzen 2008, §3.3",
//  "steps": [
//    {"title": "…", "text": ["A line", "", "    a formula"], "look": "…",
//     "at": {"world": [x, y, z]}, "session": {"format": "umbrascope-session/1", …},
//     "question": {"text": "…", "quantity": "visibility", "technique": "vsm",
//                  "low": 0, "high": 1, "tolerance": 0.02, "explanation": "…"},
//     "claims": [{"text": "…", "quantity": "visibility", "technique": "vsm", "step": 1,
//                 "relation": ">", "value": 0.2},
//                {"quantity": "rmse", "relation": "<",
//                 "than": {"quantity": "rmse", "technique": "pcf", "step": 2}},
//                {"quantity": "reference", "relation": "≈", "value": 0, "tolerance": 1e-6}]}]}
//
// A text is one string or a list of its lines, Markdown, with numbers that are computed when it is
// shown: see LessonNumbers.h. What is **bold** is a control, a pane or a key, called as the window
// calls it. The session is one that SessionFile reads; it shows a scene. The step is about the
// point "at", whatever the window's size. Where "technique" is absent it is the session's, where
// "step" is absent it is the step itself. "question", "claims", "look" and "after" may be absent.
#pragma once

#include <filesystem>
#include <string_view>

#include "datasets/lessons/Lesson.h"

namespace umbra {

// Error messages begin with `where`, the file's name. Throws BadInput that names the key for what
// is missing, unknown, of a wrong type or out of range, and for a technique or session that is not
// right.
Lesson lessonFromText(std::string_view text, std::string_view where);

// Paths of meshes in the file are relative to its folder.
Lesson readLesson(const std::filesystem::path& file);

// Whether the text says that it is a lesson, correct or not. This tells a lesson from a session.
bool looksLikeLesson(const std::filesystem::path& file);

}  // namespace umbra
