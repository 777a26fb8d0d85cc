#include "ui/kit/Preferences.h"

#include <QSettings>

#include <algorithm>

namespace lubberline::ui {

namespace {

constexpr char kLanguage[] = "view/language", kMinutes[] = "view/minutes", kDark[] = "view/dark", kTextSize[] = "view/textSize",
               kRampSize[] = "ramp/textSize", kSite[] = "defaults/site", kInstrument[] = "defaults/instrument",
               kBackupFolder[] = "backup/folder", kBackupsKept[] = "backup/keep";
constexpr int kUsualBackups = 10;

} // namespace

Preferences::Preferences(QSettings& settings, QObject* parent) : QObject(parent), m_settings(settings) {}

void Preferences::set(const char* key, const QVariant& value)
{
    if (m_settings.value(key) == value)
        return;
    m_settings.setValue(key, value);
    emit changed();
}

int Preferences::percent(const char* key) const
{
    return std::clamp(m_settings.value(key, 100).toInt(), kSmallest_percent, kLargest_percent);
}

QString Preferences::language() const { return m_settings.value(kLanguage).toString(); }
AngleStyle Preferences::angleStyle() const
{
    return m_settings.value(kMinutes, false).toBool() ? AngleStyle::DegreesMinutes : AngleStyle::DecimalDegrees;
}
bool Preferences::dark() const { return m_settings.value(kDark, false).toBool(); }
int Preferences::textSize_percent() const { return percent(kTextSize); }
int Preferences::rampSize_percent() const { return percent(kRampSize); }
QString Preferences::site() const { return m_settings.value(kSite).toString(); }
QString Preferences::instrument() const { return m_settings.value(kInstrument).toString(); }
QString Preferences::backupFolder() const { return m_settings.value(kBackupFolder).toString(); }
int Preferences::backupsKept() const { return std::clamp(m_settings.value(kBackupsKept, kUsualBackups).toInt(), 1, kMostBackups); }

void Preferences::setLanguage(const QString& language) { set(kLanguage, language); }
void Preferences::setAngleStyle(AngleStyle style) { set(kMinutes, style == AngleStyle::DegreesMinutes); }
void Preferences::setDark(bool dark) { set(kDark, dark); }
void Preferences::setTextSize_percent(int percent) { set(kTextSize, std::clamp(percent, kSmallest_percent, kLargest_percent)); }
void Preferences::setRampSize_percent(int percent) { set(kRampSize, std::clamp(percent, kSmallest_percent, kLargest_percent)); }
void Preferences::setSite(const QString& record) { set(kSite, record); }
void Preferences::setInstrument(const QString& record) { set(kInstrument, record); }
void Preferences::setBackupFolder(const QString& folder) { set(kBackupFolder, folder); }
void Preferences::setBackupsKept(int count) { set(kBackupsKept, std::clamp(count, 1, kMostBackups)); }

} // namespace lubberline::ui
