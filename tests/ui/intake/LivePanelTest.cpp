// The live strip as a crew sees it: a source over UDP, settling, two talkers, wrong checksums, silence; a log of a turn as a
// swing.

#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QUdpSocket>

#include <cmath>

#include "core/nmea/NmeaSentence.h"
#include "core/swing/Observations.h"
#include "tests/ui/window/Fixture.h"
#include "tests/ui/window/Typing.h"
#include "ui/intake/LivePanel.h"
#include "ui/intake/NmeaImportPage.h"

namespace lubberline::ui {

namespace {

QByteArray line(const std::string& body) { return QByteArray::fromStdString(makeNmea(body)) + "\r\n"; }

/// A free port for a moment: bound and let go.
int freePort()
{
    QUdpSocket socket;
    return socket.bind(QHostAddress::LocalHost, 0) ? socket.localPort() : 0;
}

} // namespace

class LivePanelTest : public QObject {
    Q_OBJECT

private slots:
    void aSettledHeadingIsTakenAndAMovingOneIsNot()
    {
        double now_s = 0;
        LivePanel panel([&now_s] { return now_s; });
        panel.show();
        QSignalSpy datum(&panel, &LivePanel::datumSettled), compass(&panel, &LivePanel::compassSettled), failed(&panel, &LivePanel::failed);
        const int port = freePort();
        in<QComboBox>(panel, "liveKind").setCurrentIndex(1);
        in<QLineEdit>(panel, "liveWhere").setText(QString::number(port));
        in<QPushButton>(panel, "liveConnect").click();
        QVERIFY2(panel.input().state() == LiveInput::State::Open, qPrintable(panel.input().words()));
        QUdpSocket sender;
        const auto send = [&](const QByteArray& bytes, int sentences) {
            const int before = panel.heading().sentences();
            sender.writeDatagram(bytes, QHostAddress::LocalHost, static_cast<quint16>(port));
            QTRY_VERIFY(panel.heading().sentences() >= before + sentences);
        };
        panel.takeDatum();
        QCOMPARE(failed.count(), 1); // nothing is heard
        for (; now_s < 6; now_s += 1)
            send(line("HCHDG," + std::to_string(100 + 5 * int(now_s)) + ",,,6.0,E") + line("GPHDT,271.0,T"), 2);
        panel.takeCompass();
        QCOMPARE(compass.count(), 0); // it turns by 5° a second
        for (; now_s < 14; now_s += 1)
            send(line("HCHDG,98.3,,,6.0,E") + line("GPHDT,271.0,T"), 2);
        QCOMPARE(in<QComboBox>(panel, "liveCompassChannel").currentText(), QString("HCHDG"));
        panel.takeCompass();
        QCOMPARE(compass.count(), 1);
        QVERIFY(qAbs(compass.front().front().toDouble() - 98.3) < 1e-9);
        QCOMPARE(in<QComboBox>(panel, "liveDatumChannel").currentText(), QString("GPHDT"));
        panel.takeDatum();
        QCOMPARE(datum.count(), 0); // the datum is magnetic, and no variation is stated
        QVERIFY(in<QLabel>(panel, "liveDatumDetail").text().contains("no variation"));
        panel.setDatum({true, true, {}});
        panel.takeDatum();
        QCOMPARE(datum.back().front().toDouble(), 271.0);
        panel.setDatum({true, false, 6.0});
        QVERIFY(in<QLabel>(panel, "liveDatumDetail").text().contains("taken as 265.0° magnetic"));
        panel.takeDatum();
        QCOMPARE(datum.back().front().toDouble(), 265.0);
        panel.setDatum({false, false, 6.0}); // a theodolite: a person reads it
        panel.takeDatum();
        QCOMPARE(datum.count(), 2);
        QVERIFY(failed.back().front().toString().contains("read by a person"));
        sender.writeDatagram("$HCHDG,12.0,,,,*00\r\n", QHostAddress::LocalHost, static_cast<quint16>(port));
        QTRY_COMPARE(panel.heading().badChecksums(), 1);
        now_s += 60; // the laptop slept
        failed.clear();
        panel.takeDatum();
        QCOMPARE(failed.count(), 1);
        QVERIFY(in<QLabel>(panel, "liveDatum").font().pixelSize() >= 48);
    }

    /// A deviation of nought that nobody measured: the sentence of the compass as its own datum, in whatever order they are heard.
    void oneSentenceIsNeverDatumAndCompass()
    {
        LivePanel panel([] { return 0.0; });
        panel.show();
        auto &datum = in<QComboBox>(panel, "liveDatumChannel"), &compass = in<QComboBox>(panel, "liveCompassChannel");
        const auto hear = [&](const char* body) { panel.heading().takeLine(makeNmea(body)); };
        const auto choose = [](QComboBox& box, const char* text) {
            box.setCurrentText(text);
            emit box.activated(box.currentIndex());
        };
        hear("HCHDM,98.0,M");
        QCOMPARE(compass.currentText(), QString("HCHDM"));
        QCOMPARE(datum.count(), 0);
        hear("HCHDG,97.5,,,6.0,E"); // what it reads before what it may have corrected
        QCOMPARE(compass.currentText(), QString("HCHDG"));
        QCOMPARE(datum.itemText(0), QString("HCHDM"));
        QCOMPARE(datum.currentIndex(), -1); // the same instrument again: not without being asked
        QSignalSpy failed(&panel, &LivePanel::failed);
        panel.takeDatum();
        QVERIFY(failed.back().front().toString().contains("choose"));
        hear("HCHDT,103.5,T"); // the compass's own with the variation added
        QCOMPARE(datum.currentIndex(), -1);
        hear("GPRMC,090000.00,A,4736.0,N,12218.0,W,6.0,27.5,201125,,,A");
        QCOMPARE(datum.currentText(), QString("GPRMC"));
        hear("GPHDT,104.0,T");
        QCOMPARE(datum.currentText(), QString("GPHDT"));
        choose(datum, "HCHDM");
        hear("GPHDT,104.0,T");
        QCOMPARE(datum.currentText(), QString("HCHDM")); // asked for, and said what it costs
        QVERIFY(in<QLabel>(panel, "liveNotes").text().contains("have one talker"));
        choose(compass, "HCHDM"); // it moves to the other side: the datum falls back
        QCOMPARE(compass.currentText(), QString("HCHDM"));
        QCOMPARE(datum.currentText(), QString("GPHDT"));
        QCOMPARE(datum.findText("HCHDM"), -1);
    }

    /// A receiver that stands still goes on sending a track: the last one, or noise.
    void theTrackOfAReceiverAtRestIsNoHeading()
    {
        double now_s = 0;
        LivePanel panel([&now_s] { return now_s; });
        panel.setDatum({true, true, {}});
        QSignalSpy taken(&panel, &LivePanel::datumSettled), failed(&panel, &LivePanel::failed);
        const auto drive = [&](const char* body) {
            for (int i = 0; i < 8; ++i, now_s += 1)
                panel.heading().takeLine(makeNmea(body));
            panel.takeDatum();
        };
        drive("GPRMC,090000.00,A,4736.0,N,12218.0,W,0.0,271.0,201125,,,A");
        QVERIFY(failed.back().front().toString().contains("0.0 kt"));
        QCOMPARE(in<QLabel>(panel, "liveDatum").text(), QString("—"));
        drive("GPVTG,271.0,T,,M,,N,,K,A"); // without its speed
        QCOMPARE(taken.count(), 0);
        drive("GPRMC,090000.00,A,4736.0,N,12218.0,W,8.0,271.0,201125,,,A");
        QCOMPARE(taken.count(), 1);
        drive("GPRMC,090000.00,A,4736.0,N,12218.0,W,1.9,271.0,201125,,,A"); // it has stopped
        QCOMPARE(taken.count(), 1);
    }

    /// Figures and words are whole beside each other as narrow as the window may be.
    void figuresAreWholeInANarrowWindow()
    {
        double now_s = 0;
        LivePanel panel([&now_s] { return now_s; });
        panel.resize(700, 200);
        panel.show();
        for (; now_s < 8; now_s += 1)
            for (const char* body : {"HCHDG,98.3,,,6.0,E", "GPHDT,271.0,T"})
                panel.heading().takeLine(makeNmea(body));
        QTRY_VERIFY(in<QLabel>(panel, "liveDatum").width() > 0);
        for (const char* name : {"liveDatum", "liveCompass"}) {
            const auto& figure = in<QLabel>(panel, name);
            QVERIFY2(figure.width() >= figure.fontMetrics().horizontalAdvance(figure.text()), name);
        }
        QCOMPARE(in<QLabel>(panel, "liveDatum").text(), QString("271.0°"));
        QVERIFY(in<QLabel>(panel, "liveCompassDetail").text().startsWith("✓ settled: moves by 0.0° over 6 headings, the last 0.0 s old"));
        QVERIFY(in<QLabel>(panel, "liveDatumDetail").width() > 150);
    }

    /// A line cut short looks like a heading of fewer digits: without its checksum it is none.
    void halfASentenceIsNoHeading()
    {
        double now_s = 0;
        LiveHeading heading([&now_s] { return now_s; });
        heading.takeLine("$HCHDG,1");
        heading.takeLine("$GPHDT,27");
        QVERIFY(heading.compassChannels().isEmpty() && heading.referenceChannels({}).isEmpty());
        heading.takeLine("$HCHDG,98.3,,,6.0,E"); // whole, from a talker without checksums
        QCOMPARE(heading.heading("HCHDG")->mean_deg, 98.3);
        heading.takeLine(makeNmea("HCHDG,98.3,,,6.0,E"));
        heading.takeLine("$HCHDG,9.3,,,6.0,E"); // it sends checksums: this one has lost its own
        QCOMPARE(heading.heading("HCHDG")->mean_deg, 98.3);
        QCOMPARE(heading.badChecksums(), 3);
    }

    void theTurnRateIsHeldAgainstTheBand()
    {
        double now_s = 0;
        LivePanel panel([&now_s] { return now_s; });
        const auto turnAt = [&](double rate) {
            for (int i = 0; i < 12; ++i, now_s += 1)
                panel.heading().takeLine(makeNmea("HCHDG," + std::to_string(wrap360(350 + rate * now_s)) + ",,,,"));
            return in<QLabel>(panel, "liveCompassDetail").text();
        };
        QVERIFY(turnAt(0).endsWith("steady"));
        QVERIFY(turnAt(1).endsWith("turns clockwise at 1.0°/s: within 0.2 … 3°/s"));
        now_s += 60;
        QVERIFY(turnAt(-6).contains("turns counter-clockwise at 6.0°/s: too fast"));
    }

    void aVariationThatIsNotTheModelsIsTold()
    {
        LiveHeading heading([] { return 0.0; });
        heading.takeLine(makeNmea("HCHDG,98.3,,,,"));
        QVERIFY(!heading.variation());
        heading.takeLine(makeNmea("GPRMC,090000.00,A,4736.0,N,12218.0,W,6.0,27.5,201125,,,A"));
        QVERIFY(qAbs(heading.variation()->variation.degrees() - 14.97) < 0.02); // WMM2025
        heading.takeLine(makeNmea("GPRMC,090001.00,A,4736.0,N,12218.0,W,6.0,27.5,201125,0.0,E,A"));
        QCOMPARE(heading.variation()->variation.degrees(), 0.0);
        QCOMPARE(heading.variation()->warnings.size(), std::size_t{1});
        heading.takeLine("{\"raw\":\"" + makeNmea("HCHDG,-3.0,,,15.2,E") + "\"} {\"raw\":\"" + makeNmea("GPHDT,271.0,T") + "\"}");
        QCOMPARE(heading.badHeadings(), 1);
        QCOMPARE(heading.heading("GPHDT")->mean_deg, 271.0); // two on a line
    }

    void aWrongPortIsRefusedInWords()
    {
        LivePanel panel;
        QSignalSpy failed(&panel, &LivePanel::failed);
        in<QComboBox>(panel, "liveKind").setCurrentIndex(1);
        for (const char* wrong : {"", "abc", "0", "70000"}) {
            in<QLineEdit>(panel, "liveWhere").setText(wrong);
            in<QPushButton>(panel, "liveConnect").click();
        }
        QCOMPARE(failed.count(), 4);
        in<QComboBox>(panel, "liveKind").setCurrentIndex(0);
        in<QLineEdit>(panel, "liveWhere").setText("/dev/ttyUSB0 fast");
        in<QPushButton>(panel, "liveConnect").click();
        QCOMPARE(failed.count(), 5);
        QCOMPARE(panel.input().state(), LiveInput::State::Closed);
    }

    /// δ = 2 + 3 sin ψ' on a slow turn with the variation 6° east; the first samples are too slow to have a track.
    void aLogOfATurnBecomesASwing()
    {
        QTemporaryDir folder;
        QFile log(folder.filePath("turn.nmea"));
        QVERIFY(log.open(QIODevice::WriteOnly));
        for (int i = 0; i < 360; ++i) {
            const double compass = i, track = compass + 2 + 3 * std::sin(compass * kRadiansPerDegree) + 6;
            const int seconds = 36000 + i;
            char rmc[120], hdg[40];
            std::snprintf(rmc, sizeof rmc, "GPRMC,%02d%02d%02d,A,5133.0,N,02153.4,E,%.1f,%.2f,231126,6.0,E", seconds / 3600,
                seconds / 60 % 60, seconds % 60, i < 20 ? 0.5 : 8.0, std::fmod(track + 360, 360));
            std::snprintf(hdg, sizeof hdg, "HCHDG,%.1f,,,6.0,E", compass);
            log.write(line(rmc) + line(hdg));
        }
        log.close();
        SmallFleet fleet;
        NmeaImportPage page(fleet.stores, {});
        page.show();
        QVERIFY(page.showCompass(fleet.compass));
        QSignalSpy made(&page, &NmeaImportPage::makeSwing), failed(&page, &NmeaImportPage::failed);
        page.readLog(log.fileName());
        QTRY_VERIFY(in<QPushButton>(page, "nmeaMake").isEnabled());
        QVERIFY2(in<QLabel>(page, "nmeaSummary").text().contains("360 pairs of headings, 340 used"),
            qPrintable(in<QLabel>(page, "nmeaSummary").text()));
        in<QPushButton>(page, "nmeaMake").click();
        QCOMPARE(made.count(), 1);
        const Swing swing = made.front().front().value<Swing>();
        QCOMPARE(swing.compass, fleet.compass);
        QCOMPARE(swing.date, Date("2026-11-23"));
        const auto analysis = analyse(observationsOf(swing));
        QVERIFY(qAbs(toDegrees(*analysis->approximate.of(Coefficient::A)) - 2) < 0.1);
        QVERIFY(qAbs(toDegrees(*analysis->approximate.of(Coefficient::B)) - 3) < 0.1);
        QVERIFY(qAbs(toDegrees(*analysis->approximate.of(Coefficient::C))) < 0.1);
        in<QLineEdit>(page, "nmeaSpeed").setText("fast");
        QTest::keyClick(&in<QLineEdit>(page, "nmeaSpeed"), Qt::Key_Return);
        QCOMPARE(failed.count(), 1);
        page.readLog(folder.filePath("missing.nmea"));
        in<QLineEdit>(page, "nmeaSpeed").setText("2");
        page.readLog(folder.filePath("missing.nmea"));
        QTRY_VERIFY(in<QLabel>(page, "nmeaSummary").text().contains("missing.nmea"));
    }
};

} // namespace lubberline::ui

QTEST_MAIN(lubberline::ui::LivePanelTest)
#include "LivePanelTest.moc"
