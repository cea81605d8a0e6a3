#include "app/lessons/LessonPage.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "analysis/errors/Measure.h"
#include "analysis/plots/ProbePlots.h"
#include "app/lessons/Markdown.h"
#include "app/lessons/PageParts.h"
#include "app/options/SceneSources.h"
#include "datasets/lessons/LessonNumbers.h"
#include "filters/core/support/Text.h"

namespace umbra {
namespace {

// A ring round the probed pixel: amber, with a white edge on either side.
void markProbe(Image<std::uint8_t>& picture, Pixel centre) {
  const double radius = picture.height() / 40.0, half = picture.height() / 400.0;
  const int reach = int(radius + 3 * half) + 1;
  for (int y = std::max(0, centre.y - reach); y < std::min(picture.height(), centre.y + reach); ++y)
    for (int x = std::max(0, centre.x - reach); x < std::min(picture.width(), centre.x + reach);
         ++x) {
      const double off = std::abs(std::hypot(x - centre.x, y - centre.y) - radius);
      if (off > 2 * half) continue;
      const std::uint8_t amber[] = {0xf5, 0x9e, 0x0b}, white[] = {0xff, 0xff, 0xff};
      std::copy_n(off <= half ? amber : white, 3, picture.pixel(x, y).begin());
    }
}

// Without what stands before the element: an XML declaration is not for the middle of a page.
std::string inlineSvg(const std::string& svg) {
  const std::size_t start = svg.find("<svg");
  return start == std::string::npos ? std::string() : svg.substr(start);
}

std::string captionOf(const Session& session, const SceneProbe& probe) {
  std::string adjusted;
  for (const auto& [name, value] : session.source.parameters)
    adjusted += (adjusted.empty() ? " with " : ", ") + name + " " + shortNumber(value);
  return "Scene " + shortNameOf(session.source) + adjusted + ", technique " + session.technique +
         ", " + describe(session.frame.kernel) + ", map of " +
         std::to_string(session.frame.map.size) + " texels a side, stored as " +
         std::string(nameOf(session.frame.map.format)) +
         (probe.hidden ? "." : ". The ring marks the point that the step is about.");
}

std::string pictureHtml(Display& display, const LessonStep& step, const StepResult& result) {
  Image<std::uint8_t> picture = result.picture;
  if (!result.probe.hidden) markProbe(picture, result.probe.pixel);
  return pictureInPage(display.pngOf(picture), captionOf(step.session, result.probe));
}

std::string plotsHtml(Display& display, const LessonStep& step, const StepResult& result) {
  const Probe& probe = result.probe.probe;
  std::string html;
  for (const Plot& plot : {curvesPlot(probe, step.session.technique), histogramPlot(probe)})
    html += "<figure>" + inlineSvg(display.svgOf(plot)) + "</figure>\n";
  return html;
}

std::string claimsHtml(const Lesson& lesson, const LessonStep& step,
                       const std::vector<StepResult>& results) {
  if (step.claims.empty()) return {};
  const auto name = [&](const LessonQuantity& quantity) {
    const bool here = &lesson.steps[quantity.step] == &step;
    return describe(quantity) + (here ? "" : ", step " + std::to_string(quantity.step + 1));
  };
  std::string html =
      "<table><tr><th>What is claimed</th><th>Quantity</th><th>Measured</th><th></th>"
      "<th>Against</th></tr>\n";
  for (const LessonClaim& claim : step.claims) {
    const ClaimResult result = checkClaim(results, claim);
    html += "<tr><td>" + escapedHtml(claim.text) + "</td><td>" + escapedHtml(name(claim.left)) +
            "</td><td class=\"figure\">" + shortNumber(result.left) + "</td><td>" +
            escapedHtml(nameOf(claim.relation)) + "</td><td class=\"figure\">" +
            shortNumber(result.right) +
            (claim.right ? " (" + escapedHtml(name(*claim.right)) + ")" : std::string()) +
            "</td></tr>\n";
  }
  return html + "</table>\n";
}

std::string questionHtml(const LessonStep& step, const StepResult& result,
                         const std::function<std::string(const std::string&)>& toHtml,
                         const std::string& evidence) {
  const LessonQuestion& question = *step.question;
  const Probe& probe = result.probe.probe;
  const double value = *measured(probe, question.asked.quantity, question.asked.technique);
  std::string html = "<div class=\"question\"><p class=\"label\">Predict first</p>\n" +
                     toHtml(question.text) +
                     "<p>My prediction: <span class=\"answer\">&nbsp;</span></p>\n"
                     "<details><summary>What the program measures</summary>\n";
  html += "<p><strong>" + escapedHtml(describe(question.asked)) + " = " + shortNumber(value) +
          "</strong>. A prediction within ±" + shortNumber(question.tolerance) +
          " of it is right.</p>\n" + toHtml(question.explanation);
  const std::string cause =
      infoOf(question.asked.quantity).ofTechnique ? causeOf(probe, question.asked.technique) : "";
  if (!cause.empty()) html += "<p>" + escapedHtml(cause) + "</p>\n";
  return html + evidence + "</details></div>\n";
}

std::string stepHtml(Display& display, const Lesson& lesson, std::size_t index,
                     const std::vector<StepResult>& results) {
  const LessonStep& step = lesson.steps[index];
  const StepResult& result = results[index];
  const LessonValues values = [&](const LessonQuantity& quantity) {
    return measured(result.probe.probe, quantity.quantity, quantity.technique);
  };
  const auto toHtml = [&](const std::string& text) {
    return markdownToHtml(filled(text, step, index, values));
  };
  const std::string evidence = plotsHtml(display, step, result) + claimsHtml(lesson, step, results);
  std::string html = "<section>\n<h2><span class=\"number\">" + std::to_string(index + 1) +
                     "</span>" + escapedHtml(step.title) + "</h2>\n" + toHtml(step.text) +
                     pictureHtml(display, step, result);
  if (!step.look.empty())
    html += "<div class=\"look\"><p class=\"label\">Look at</p>\n" + toHtml(step.look) + "</div>\n";
  html += step.question ? questionHtml(step, result, toHtml, evidence) : evidence;
  return html + "</section>\n";
}

}  // namespace

std::string lessonPage(Display& display, const Lesson& lesson,
                       const std::vector<StepResult>& results) {
  std::string html = pageStart(lesson.title) + "<header>\n<h1>" + escapedHtml(lesson.title) +
                     "</h1>\n" + markdownToHtml(lesson.summary);
  if (!lesson.after.empty())
    html += "<p class=\"after\">After " + escapedHtml(lesson.after) + "</p>\n";
  html += "</header>\n";
  for (std::size_t step = 0; step < lesson.steps.size(); ++step)
    html += stepHtml(display, lesson, step, results);
  return html + "<footer><p>Pictures, plots and figures by Umbrascope, lesson “" +
         escapedHtml(lesson.name) + "”. Depth and visibility run from 0 to 1.</p></footer>\n" +
         "</body>\n</html>\n";
}

std::string lessonText(const Lesson& lesson) {
  std::string text = lesson.title + "\n" + markdownToText(lesson.summary);
  if (!lesson.after.empty()) text += "After " + lesson.after + "\n";
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
    const LessonStep& step = lesson.steps[i];
    const auto toText = [&](const std::string& markdown) {
      return markdownToText(
          filled(markdown, step, i, [](const LessonQuantity&) { return std::optional<double>(); }));
    };
    text += "\n" + std::to_string(i + 1) + "  " + step.title + "\n\n" + toText(step.text);
    if (!step.look.empty()) text += "\nLook at: " + toText(step.look);
    if (!step.question) continue;
    text += "\nPredict first:\n" + toText(step.question->text) + "(" +
            describe(step.question->asked) + ", " + shortNumber(step.question->low) + " to " +
            shortNumber(step.question->high) + ")\n";
  }
  return text;
}

}  // namespace umbra
