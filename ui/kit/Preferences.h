#pragma once
/// What people choose once for all: kept in the settings, told to whoever shows it. A value that is not there, or makes no sense, is
/// that of a new user.

#include <QObject>
#include <QString>

#include "core/angle/AngleText.h"

class QSettings;

namespace lubberline::ui {

class Preferences : public QObject {
    Q_OBJECT

public:
    explicit Preferences(QSettings& settings, QObject* parent = nullptr);

    [[nodiscard]] QString language() const; ///< "pl"; empty: that of the system
    [[nodiscard]] AngleStyle angleStyle() const;
    [[nodiscard]] bool dark() const;
    [[nodiscard]] int textSize_percent() const; ///< of everything, kSmallest … kLargest
    [[nodiscard]] int rampSize_percent() const; ///< of the guided pages on top of it
    [[nodiscard]] QString site() const;         ///< RecordId of the base that a new swing begins with; empty: none
    [[nodiscard]] QString instrument() const;   ///< likewise of its datum instrument
    [[nodiscard]] QString backupFolder() const; ///< empty: it is asked for
    [[nodiscard]] int backupsKept() const;

    void setLanguage(const QString& language);
    void setAngleStyle(AngleStyle style);
    void setDark(bool dark);
    void setTextSize_percent(int percent);
    void setRampSize_percent(int percent);
    void setSite(const QString& record);
    void setInstrument(const QString& record);
    void setBackupFolder(const QString& folder);
    void setBackupsKept(int count);

    static constexpr int kSmallest_percent = 80, kLargest_percent = 200, kStep_percent = 10;
    static constexpr int kMostBackups = 100;

signals:
    void changed();

private:
    void set(const char* key, const QVariant& value);
    [[nodiscard]] int percent(const char* key) const;
    QSettings& m_settings;
};

} // namespace lubberline::ui
