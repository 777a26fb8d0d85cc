#include "ui/report/page/DocumentFont.h"

#include <QFontDatabase>
#include <QFontInfo>
#include <QGuiApplication>
#include <QRawFont>

#include <algorithm>

#include "ui/report/page/Page.h"
#include "ui/report/page/Words.h"

namespace lubberline::ui {

namespace {

constexpr char kPreferred[] = "DejaVu Sans";

/// Qt lists families that do not exist when fontconfig finds no file, so the standard font is asked for a glyph.
QString systemFamily()
{
    const QFont font = QGuiApplication::font();
    const QRawFont raw = QRawFont::fromFont(font);
    return raw.isValid() && raw.supportsCharacter(QChar('0')) ? QFontInfo(font).family() : QString();
}

} // namespace

Result<QString> chooseFamily(const QStringList& installed, const QString& system)
{
    if (system.isEmpty()) {
        return Error{ErrorCode::Unsupported,
            said(Words::tr("no font is installed, and a document without one would be blank; install the package fonts-dejavu-core"))};
    }
    return installed.contains(QLatin1String(kPreferred)) ? QString(kPreferred) : system;
}

Result<QString> documentFamily() { return chooseFamily(QFontDatabase::families(), systemFamily()); }

QFont documentFont(const QString& family, double size_pt, bool bold)
{
    constexpr double kMmPerPoint = 25.4 / 72.0;
    QFont font(family);
    font.setPixelSize(std::max(1, qRound(mm(size_pt * kMmPerPoint))));
    font.setBold(bold);
    font.setHintingPreference(QFont::PreferNoHinting); // hinted widths would follow the resolution
    // Letters that are spaced, however little, are not drawn as ligatures, by which "configuration" would not be found in a
    // PDF.
    font.setLetterSpacing(QFont::AbsoluteSpacing, mm(0.0005));
    return font;
}

} // namespace lubberline::ui
