// A page that nobody touches comes to rest: a label whose height changes its own width, or a geometry that is set on every layout, would
// lay it out for ever, and take a processor core with it.

#include <QTest>

#include "tests/ui/window/EveryPage.h"

using namespace lubberline;
using namespace lubberline::ui;

namespace {

/// Counts what a window does that lays itself out or paints itself.
class Unrest : public QObject {
public:
    bool eventFilter(QObject* object, QEvent* event) override
    {
        const auto type = event->type();
        if (object->isWidgetType() && (type == QEvent::LayoutRequest || type == QEvent::Resize || type == QEvent::UpdateRequest)) {
            ++events;
            where = QStringLiteral("%1 %2, event %3").arg(QLatin1String(object->metaObject()->className()), object->objectName()).arg(type);
        }
        return false;
    }
    int events = 0;
    QString where;
};

/// Until nothing comes for a while. @return how many turns it took; more than `most`: it never came
int turnsToRest(Unrest& unrest, int most)
{
    constexpr int kQuiet = 4;
    int quiet = 0, turns = 0;
    while (quiet < kQuiet && turns <= most) {
        unrest.events = 0;
        QTest::qWait(1);
        quiet = unrest.events == 0 ? quiet + 1 : 0;
        ++turns;
    }
    return turns;
}

} // namespace

class PagesRestTest : public QObject {
    Q_OBJECT

private slots:
    void everyPageComesToRest_data()
    {
        QTest::addColumn<QSize>("size");
        QTest::newRow("small") << QSize(1024, 700);
        QTest::newRow("usual") << QSize(1366, 728);
    }

    void everyPageComesToRest()
    {
        QFETCH(QSize, size);
        QApplication::setCursorFlashTime(0);
        SmallFleet fleet;
        OpenWindow open(fleet.stores);
        open.window.resize(size);
        Unrest unrest;
        qApp->installEventFilter(&unrest);
        QStringList restless;
        int looks = 0;
        everyPage(open, fleet, [&](const QString& where) {
            ++looks;
            if (constexpr int kMost = 120; turnsToRest(unrest, kMost) > kMost)
                restless += QStringLiteral("%1: %2").arg(where, unrest.where);
        });
        QVERIFY2(restless.isEmpty(), qPrintable(restless.join('\n')));
        QVERIFY(looks > 40);
    }
};

QTEST_MAIN(PagesRestTest)
#include "PagesRestTest.moc"
