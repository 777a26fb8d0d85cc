#pragma once
/// A window on a small fleet in memory, with dialogs that answer themselves.

#include <QApplication>
#include <QFile>
#include <QLabel>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

#include "tests/db/TestStores.h"
#include "ui/kit/MessagePanel.h"
#include "ui/swing/Gathering.h"
#include "ui/swing/SwingEditor.h"
#include "ui/swing/SwingPage.h"
#include "ui/swing/readings/ReadingsModel.h"
#include "ui/swing/readings/ReadingsTable.h"
#include "ui/window/MainWindow.h"

namespace lubberline::ui {

class AnsweringDialogs final : public Dialogs {
public:
    QString answer;
    int previews = 0;
    std::function<void(const std::function<void(QPrinter&)>&)> onPreview;
    Progress patience; ///< of who looks at the preview
    QString openFile(QWidget*, const QString&, const QString&) override { return answer; }
    QString suggested;
    std::function<void()> meanwhile; ///< what happens while a name is asked for
    QString saveFile(QWidget*, const QString&, const QString& suggestion, const QString&) override
    {
        suggested = suggestion;
        if (meanwhile)
            meanwhile();
        return answer;
    }
    QString chooseFolder(QWidget*, const QString&, const QString&) override { return answer; }
    QString openedOutside;
    bool openOutside(const QString& path) override
    {
        openedOutside = path;
        return true;
    }
    bool prints = false; ///< what is previewed
    Result<bool> printPreview(QWidget*, const PaintPages& paint, Where) override
    {
        ++previews;
        Result<void> painted;
        if (onPreview)
            onPreview([&](QPrinter& printer) { painted = paint(printer, patience); });
        if (!painted && painted.error().code != ErrorCode::Cancelled)
            return painted.error();
        return prints && painted;
    }
};

/// Type → aircraft → compass with limits of 10°, and one empty draft swing.
struct SmallFleet {
    test::TestStores stores;
    AircraftTypeId type;
    AircraftId aircraft;
    CompassId compass;
    SwingId swing;

    SmallFleet()
    {
        AircraftType su22;
        su22.name = "Su-22";
        type = *stores.save(su22);
        Aircraft one;
        one.type = type;
        one.registration = "3713";
        aircraft = *stores.save(one);
        LimitsProfile limits;
        limits.name = "25.1327";
        limits.document = "14 CFR 25.1327";
        limits.maxDeviation_deg = 10.0;
        CompassSystem standby;
        standby.aircraft = aircraft;
        standby.name = "standby compass";
        standby.limits = *stores.save(limits);
        compass = *stores.save(standby);
        swing = addSwing("2026-11-20", {});
    }

    /// Readings: magnetic and compass headings [deg].
    SwingId addSwing(Date date, const std::vector<std::pair<double, double>>& headings_deg)
    {
        Swing made;
        made.compass = compass;
        made.date = date;
        for (const auto& [magnetic_deg, compass_deg] : headings_deg) {
            Reading reading;
            reading.magnetic = MagneticHeading::fromDegrees(magnetic_deg);
            reading.compass = CompassHeading::fromDegrees(compass_deg);
            made.readings.push_back(reading);
        }
        return *stores.swings.add(made);
    }
};

struct OpenWindow {
    AnsweringDialogs dialogs;
    QTemporaryDir folder;
    QSettings settings;
    int demonstrations = 0;
    MainWindow window;

    /// @param databases with what leads to other databases.
    /// @param kept settings of a window before; none: of a new user
    explicit OpenWindow(db::Stores& stores, bool databases = false, const QSettings* kept = nullptr)
        : settings(folder.filePath("settings.ini"), QSettings::IniFormat)
        , window(stores, services(databases, kept))
    {
        window.resize(1366, 720);
        window.show();
        QApplication::setActiveWindow(&window);
        QApplication::processEvents();
        QApplication::processEvents();
    }

    QString backedUpTo, opened;
    bool writeBackups = false, refuse = false;
    Result<void> backup(const QString& path)
    {
        backedUpTo = path; // on the window's worker, which finishWriting() waits for
        if (QFile file(path); writeBackups && !file.open(QIODevice::WriteOnly))
            qFatal("the test's backup cannot be written");
        return {};
    }
    WindowServices services(bool databases, const QSettings* kept)
    {
        for (const QString& key : kept ? kept->allKeys() : QStringList())
            settings.setValue(key, kept->value(key));
        WindowServices made{dialogs, settings, [this] { ++demonstrations; }, [this](const QString& path) { return backup(path); }};
        if (!databases)
            return made;
        made.openDatabase = [this](const QString& path, bool make) -> Result<void> {
            if (refuse)
                return Error{ErrorCode::Format, Message::verbatim(std::string("no database"))};
            opened = path + (make ? " made" : "");
            return {};
        };
        made.restore = [this](const QString& path) -> Result<void> {
            opened = path + " restored";
            return {};
        };
        return made;
    }

    template <class Widget>
    Widget& find(const char* name)
    {
        auto* widget = window.findChild<Widget*>(QString::fromLatin1(name));
        if (!widget)
            qFatal("there is no widget named %s", name);
        return *widget;
    }
    ReadingsTable& table() { return static_cast<ReadingsTable&>(find<QTableView>("readingsTable")); }
    /// With what it does on the side: a document is put together by a worker.
    void trigger(const char* action)
    {
        find<QAction>(action).trigger();
        for (auto* documents : window.findChildren<Gathering*>())
            documents->finish();
        finishWriting();
    }
    void finishWriting()
    {
        auto& strip = find<QWidget>("progressStrip");
        if (!QTest::qWaitFor([&strip] { return strip.isHidden(); }, 30000))
            qFatal("a file is still being written");
    }
    /// Keys as a person types them: into the editor when one is open.
    void type(const QString& text)
    {
        for (const QChar character : text)
            QTest::keyClick(target(), character.toLatin1());
    }
    void press(Qt::Key key) { QTest::keyClick(target(), key); }
    QString cell(int row, ReadingColumn column) { return table().model()->index(row, int(column)).data().toString(); }
    QString label(const char* name) { return find<QLabel>(name).text(); }

private:
    QWidget* target()
    {
        for (QWidget* editor : table().findChildren<QWidget*>("readingEditor"))
            if (editor->isVisible()) // one that was closed lives on until the event loop deletes it
                return editor;
        return &table();
    }
};

/// δ = 1 + 3 sin ψ' − 2 cos ψ' on eight points, read to a tenth of a degree.
inline std::vector<std::pair<double, double>> eightPoints()
{
    std::vector<std::pair<double, double>> readings;
    for (int i = 0; i < 8; ++i) {
        const double compass_deg = 45.0 * i, compass_rad = compass_deg * kRadiansPerDegree;
        const double deviation_deg = 1.0 + 3.0 * std::sin(compass_rad) - 2.0 * std::cos(compass_rad) + (i % 2 ? 0.05 : -0.05);
        readings.emplace_back(compass_deg + deviation_deg, compass_deg);
    }
    return readings;
}

} // namespace lubberline::ui
