// Sentences over a pseudo-terminal (as a serial port), over UDP and from a log: whole, in pieces, damaged, from two talkers;
// and a port that vanishes and comes back.

#include <QTemporaryFile>
#include <QTest>
#include <QTimer>
#include <QUdpSocket>

#include <fcntl.h>
#include <pty.h>
#include <unistd.h>

#include <atomic>
#include <thread>
#include <utility>

#include "core/nmea/NmeaSentence.h"
#include "ui/intake/LiveHeading.h"
#include "ui/intake/LiveInput.h"

using namespace lubberline;
using namespace lubberline::ui;

namespace {

/// Both ends of a pseudo-terminal: what is written to the master arrives at the port.
class PseudoTerminal {
public:
    PseudoTerminal()
    {
        char name[128] = {};
        m_good = openpty(&m_master, &m_slave, name, nullptr, nullptr) == 0;
        m_name = QString::fromLocal8Bit(name);
    }
    ~PseudoTerminal() { pull(); }
    PseudoTerminal(const PseudoTerminal&) = delete;
    PseudoTerminal& operator=(const PseudoTerminal&) = delete;
    [[nodiscard]] bool good() const { return m_good; }
    [[nodiscard]] QString name() const { return m_name; }
    void send(const QByteArray& bytes) const { QCOMPARE(::write(m_master, bytes.constData(), bytes.size()), ssize_t(bytes.size())); }
    /// The plug is pulled.
    void pull()
    {
        for (int* end : {&m_master, &m_slave}) {
            if (*end >= 0)
                ::close(*end);
            *end = -1;
        }
    }

private:
    int m_master = -1, m_slave = -1;
    bool m_good = false;
    QString m_name;
};

QByteArray sentence(const char* body) { return QByteArray::fromStdString(makeNmea(body)) + "\r\n"; }

/// Everything between the wire and the averaged heading, with a clock that the test turns.
struct Listener {
    double now_s = 0;
    LiveInput input;
    LiveHeading heading{[this] { return now_s; }};
    Listener() { QObject::connect(&input, &LiveInput::lineReceived, &heading, &LiveHeading::takeLine); }
};

} // namespace

class LiveInputTest : public QObject {
    Q_OBJECT

private slots:
    void sentencesOfASerialPort()
    {
        PseudoTerminal port;
        QVERIFY(port.good());
        Listener listener;
        listener.input.open(SerialSettings{port.name(), 4800});
        QVERIFY2(listener.input.state() == LiveInput::State::Open, qPrintable(listener.input.words()));
        const QByteArray whole = sentence("HCHDG,98.3,0.0,E,12.6,W");
        port.send(whole.first(9));
        port.send(whole.sliced(9) + "\xff\x01 babble\r\n$HCHDG,12.0,,,,*00\r\n" + sentence("GPHDT,274.07,T"));
        QTRY_COMPARE(listener.heading.sentences(), 2);
        QCOMPARE(listener.heading.badChecksums(), 1);
        QCOMPARE(listener.heading.compassChannels(), QStringList{"HCHDG"});
        QCOMPARE(listener.heading.referenceChannels("HCHDG"), QStringList{"GPHDT"});
        QCOMPARE(listener.heading.heading("HCHDG")->mean_deg, 98.3);
        QVERIFY(!listener.heading.isTrue("HCHDG"));
        QVERIFY(listener.heading.isTrue("GPHDT"));
        QCOMPARE(listener.heading.variation()->variation.degrees(), -12.6);
    }

    void aPortThatVanishes()
    {
        PseudoTerminal port;
        Listener listener;
        listener.input.open(SerialSettings{port.name(), 4800});
        QCOMPARE(listener.input.state(), LiveInput::State::Open);
        port.send("$HCHDG,98");
        port.pull();
        QTRY_COMPARE(listener.input.state(), LiveInput::State::Waiting);
        QVERIFY(listener.input.words().contains("trying again"));
        listener.input.close();
        QTest::qWait(50);
        QCOMPARE(listener.input.state(), LiveInput::State::Closed);
    }

    void aPortThatIsNotThere()
    {
        Listener listener;
        listener.input.open(SerialSettings{"/dev/none-such", 4800});
        QCOMPARE(listener.input.state(), LiveInput::State::Waiting);
        QVERIFY(listener.input.words().contains("/dev/none-such"));
    }

    void datagrams()
    {
        QUdpSocket probe; // a port that is free
        QVERIFY(probe.bind(QHostAddress::LocalHost, 0));
        const int port = probe.localPort();
        probe.close();
        Listener listener;
        listener.input.open(UdpSettings{port});
        QVERIFY2(listener.input.state() == LiveInput::State::Open, qPrintable(listener.input.words()));
        QUdpSocket sender;
        sender.writeDatagram(sentence("HCHDG,10.0,,,,") + sentence("IIHDG,12.0,,,,"), QHostAddress::LocalHost, static_cast<quint16>(port));
        sender.writeDatagram("$HCHDG,1", QHostAddress::LocalHost, static_cast<quint16>(port)); // cut short
        sender.writeDatagram(sentence("GPRMC,100000,A,5210.00,N,02057.00,E,8.0,45.0,231126,6.5,E").trimmed(), QHostAddress::LocalHost,
            static_cast<quint16>(port));
        QTRY_VERIFY(listener.heading.referenceChannels("HCHDG").contains("GPRMC"));
        QCOMPARE(listener.heading.compassChannels(), (QStringList{"HCHDG", "IIHDG"})); // two talkers stay two
        QCOMPARE(listener.heading.heading("GPRMC")->mean_deg, 45.0);
        QCOMPARE(listener.heading.variation()->variation.degrees(), 6.5);
    }

    /// Nobody in the network, and nobody else on this machine: unless it is asked for.
    void aUdpPortIsThisMachinesAndOursAlone()
    {
        QUdpSocket other; // takes the port first
        QVERIFY(other.bind(QHostAddress::LocalHost, 0, QUdpSocket::ShareAddress | QUdpSocket::ReuseAddressHint));
        const int port = other.localPort();
        Listener listener;
        listener.input.open(UdpSettings{port});
        QCOMPARE(listener.input.state(), LiveInput::State::Waiting);
        other.close();
        listener.input.open(UdpSettings{port});
        QCOMPARE(listener.input.state(), LiveInput::State::Open);
        QVERIFY(listener.input.words().contains("this machine only"));
        QUdpSocket second;
        QVERIFY(!second.bind(QHostAddress::LocalHost, static_cast<quint16>(port), QUdpSocket::ShareAddress | QUdpSocket::ReuseAddressHint));
        // A datagram to another address of this machine does not reach it.
        QUdpSocket sender;
        sender.writeDatagram(sentence("HCHDG,10.0,,,,"), QHostAddress("127.0.0.2"), static_cast<quint16>(port));
        sender.writeDatagram(sentence("HCHDG,20.0,,,,"), QHostAddress::LocalHost, static_cast<quint16>(port));
        QTRY_COMPARE(listener.heading.sentences(), 1);
        QCOMPARE(listener.heading.heading("HCHDG")->mean_deg, 20.0);
        listener.input.open(UdpSettings{port, true});
        sender.writeDatagram(sentence("IIHDG,30.0,,,,"), QHostAddress("127.0.0.2"), static_cast<quint16>(port));
        QTRY_VERIFY(listener.heading.compassChannels().contains("IIHDG"));
    }

    /// A sender as fast as the machine can: the window's thread gets so many lines and no more, the others are counted, and a quiet
    /// instrument beside it is heard.
    void aFloodIsThinnedAndAQuietInstrumentHeard()
    {
        QUdpSocket probe;
        QVERIFY(probe.bind(QHostAddress::LocalHost, 0));
        const auto port = probe.localPort();
        probe.close();
        Listener listener;
        int batches = 0, most = 0, inBatch = 0;
        QObject::connect(&listener.input, &LiveInput::lineReceived, [&] { ++inBatch; });
        QObject::connect(&listener.input, &LiveInput::delivered, [&] {
            ++batches;
            most = std::max(most, std::exchange(inBatch, 0));
        });
        listener.input.open(UdpSettings{port});
        QCOMPARE(listener.input.state(), LiveInput::State::Open);
        std::atomic<bool> flooding{true};
        std::atomic<qint64> sent{0};
        std::thread flood([&] {
            QUdpSocket socket;
            const QByteArray many = sentence("XXHDG,1.0,,,,").repeated(20);
            while (flooding)
                sent += socket.writeDatagram(many, QHostAddress::LocalHost, port) > 0 ? 20 : 0;
        });
        QUdpSocket quiet;
        int keys = 0; // what else the window does in the meantime
        QTimer typing;
        QObject::connect(&typing, &QTimer::timeout, [&] {
            ++keys;
            quiet.writeDatagram(sentence("HCHDG,98.0,,,,"), QHostAddress::LocalHost, port);
        });
        typing.start(20);
        const bool dropped = QTest::qWaitFor([&] { return listener.input.dropped() > 10000 && keys > 50; }, 30000);
        flooding = false;
        flood.join();
        QVERIFY2(dropped, qPrintable(QString("%1 sent, %2 dropped, %3 keys").arg(sent).arg(listener.input.dropped()).arg(keys)));
        QVERIFY(most <= 200);
        QTRY_VERIFY(listener.heading.compassChannels().contains("HCHDG"));
        listener.input.close();
        QCOMPARE(listener.input.state(), LiveInput::State::Closed);
    }

    void manySendersAreNotManyInstruments()
    {
        LiveHeading heading([] { return 0.0; });
        for (int i = 0; i < 1000; ++i)
            heading.takeLine(makeNmea(std::string{char('A' + i / 26 % 26), char('A' + i % 26)} + "HDG,1.0,,,,"));
        QCOMPARE(heading.compassChannels().size(), 64);
        QVERIFY(heading.badChecksums() > 0);
    }

    void aReplayedLogSettles()
    {
        QTemporaryFile log;
        QVERIFY(log.open());
        for (int i = 0; i < 20; ++i)
            log.write(sentence(i % 2 ? "HCHDG,359.8,,,," : "HCHDG,0.2,,,,"));
        log.close();
        Listener listener;
        QObject::connect(&listener.input, &LiveInput::lineReceived, &listener.heading, [&listener] { listener.now_s += 0.5; });
        listener.input.open(ReplaySettings{log.fileName(), 1000});
        QTRY_COMPARE(listener.input.state(), LiveInput::State::Closed);
        QVERIFY(listener.input.words().contains("ended"));
        QCOMPARE(listener.heading.sentences(), 20);
        const auto settled = listener.heading.heading("HCHDG");
        QVERIFY(settled && settled->settled);
        QVERIFY(std::abs(wrap180(settled->mean_deg)) < 0.03);
        listener.now_s += 60;
        QVERIFY(!listener.heading.heading("HCHDG")); // silent: nothing is shown as if it were now
    }

    void aLogThatCannotBeRead()
    {
        Listener listener;
        listener.input.open(ReplaySettings{"/none/such.nmea", 10});
        QCOMPARE(listener.input.state(), LiveInput::State::Closed);
        QVERIFY(listener.input.words().contains("such.nmea"));
    }
};

QTEST_MAIN(LiveInputTest)
#include "LiveInputTest.moc"
