#include "ui/window/menus/HelpDialogs.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QImage>
#include <QTextBrowser>
#include <QTextDocument>
#include <QUrl>
#include <QVBoxLayout>

#include "filters/core/technique/TechniquePage.h"
#include "ui/widgets/base/Style.h"

namespace umbra {
namespace {

QTextBrowser* openPage(const QString& title, const QSize& size, QWidget* parent) {
  auto* dialog = new QDialog(parent);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(title);
  dialog->setObjectName("help");
  auto* page = new QTextBrowser;
  page->setOpenExternalLinks(true);
  page->setFrameShape(QFrame::NoFrame);
  page->document()->setDocumentMargin(18);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::close);
  auto* layout = new QVBoxLayout(dialog);
  layout->setContentsMargins(0, 0, 0, 8);
  layout->addWidget(page, 1);
  layout->addWidget(buttons);
  dialog->resize(size);
  dialog->show();
  return page;
}

}  // namespace

void showTechniquePage(const Technique& technique, QWidget* parent) {
  QTextBrowser* page = openPage(style::text(technique.info().title), {760, 680}, parent);
  const std::string text = pageOf(*technique.clone());
  page->document()->setMarkdown(style::text(text));
  for (const std::string& name : pictureNames(text)) {
    const std::span<const unsigned char> bytes = pagePicture(name);
    const QImage picture = QImage::fromData(bytes.data(), int(bytes.size()));
    page->document()->addResource(QTextDocument::ImageResource, QUrl(QString::fromStdString(name)),
                                  picture);
  }
  // The text was laid out before it had its pictures, without room for them.
  page->document()->markContentsDirty(0, page->document()->characterCount());
}

void showShortcuts(const std::vector<std::pair<QString, QString>>& shortcuts, QWidget* parent) {
  QTextBrowser* page = openPage(QObject::tr("Keyboard and mouse"), {460, 620}, parent);
  QString rows;
  for (const auto& [what, key] : shortcuts)
    rows += QString("<tr><td style='padding: 2px 24px 2px 0'>%1</td><td><b>%2</b></td></tr>")
                .arg(what.toHtmlEscaped(), key.toHtmlEscaped());
  page->setHtml("<table>" + rows + "</table>");
}

void showAbout(QWidget* parent) {
  QTextBrowser* page = openPage(QObject::tr("About Umbrascope"), {460, 320}, parent);
  page->setHtml(QObject::tr(
      "<h2>Umbrascope</h2>"
      "<p>Shows why filtered shadow maps are wrong: one pixel at a time, with the filter region, "
      "what every technique makes of it, and the reference.</p>"
      "<p>Free software under the BSD 3-clause licence. Built on VTK, Qt, Qwt, OpenMesh, OpenEXR "
      "and Eigen.</p>"));
}

}  // namespace umbra
