// Work on a thread of its own: who hears of it, and when it ends.

#include <QtTest>

#include <QSemaphore>
#include <QThread>

#include "ui/kit/Worker.h"

namespace lubberline::ui {

class WorkerTest : public QObject {
    Q_OBJECT

private slots:
    void deliversItsResultOnTheThreadThatAsked()
    {
        QThread* workedOn = nullptr;
        QThread* deliveredOn = nullptr;
        int result = 0;
        Worker<int> worker([&](const Result<int>& answer) {
            deliveredOn = QThread::currentThread();
            result = answer.value();
        });
        QVERIFY(!worker.running());
        worker.start([&workedOn](const Progress&) -> Result<int> {
            workedOn = QThread::currentThread();
            return 42;
        });
        QVERIFY(worker.running());
        QCOMPARE(result, 0); // not before the window comes to it
        QTRY_COMPARE(result, 42);
        QVERIFY(!worker.running());
        QCOMPARE(deliveredOn, QThread::currentThread());
        QVERIFY(workedOn && workedOn != QThread::currentThread());
    }

    void tellsEachPercentOnce()
    {
        QList<int> told;
        bool done = false;
        Worker<int> worker([&done](const Result<int>&) { done = true; }, [&told](int percent) { told += percent; });
        worker.start([](const Progress& progress) -> Result<int> {
            for (const double fraction : {0.0, 0.001, 0.5, 0.504, 1.0})
                progress(fraction);
            return 1;
        });
        QTRY_VERIFY(done);
        QCOMPARE(told, (QList<int>{0, 50, 100}));
    }

    void givesUpWhenItIsCancelled()
    {
        ErrorCode code = ErrorCode::Io;
        QSemaphore begun;
        Worker<int> worker([&code](const Result<int>& answer) { code = answer.error().code; });
        worker.start([&begun](const Progress& progress) -> Result<int> {
            begun.release();
            while (progress(0.5))
                QThread::msleep(1);
            return Error{ErrorCode::Cancelled, MARKED("ui", "cancelled")};
        });
        begun.acquire();
        worker.cancel();
        QVERIFY(worker.running());
        QTRY_COMPARE(code, ErrorCode::Cancelled);
        QVERIFY(!worker.running());
        worker.cancel(); // nothing runs
    }

    void theNewestWins()
    {
        QList<int> delivered, told;
        std::atomic<int> atOnce{0}, most{0}, begun{0};
        Worker<int> worker([&delivered](const Result<int>& answer) { delivered += answer ? answer.value() : -1; },
            [&told](int percent) { told += percent; });
        for (int i = 1; i <= 20; ++i) {
            worker.start([i, &atOnce, &most, &begun](const Progress& progress) -> Result<int> {
                ++begun;
                most = std::max(most.load(), ++atOnce);
                for (int step = 0; step < 5 && progress(0.01 * i); ++step)
                    QThread::msleep(1);
                --atOnce;
                return i; // also when it was cancelled: nobody hears of it
            });
            if (i % 5 == 0)
                QThread::msleep(2);
        }
        QTRY_VERIFY(!worker.running());
        QTest::qWait(20);
        QCOMPARE(delivered, QList<int>{20});
        QCOMPARE(told, QList<int>{20});
        QCOMPARE(most.load(), 1); // the one before has let go first
        QVERIFY(begun <= 20);
    }

    void aReplacedResultThatWasOnItsWayIsDropped()
    {
        QList<int> delivered;
        QSemaphore returned;
        Worker<int> worker([&delivered](const Result<int>& answer) { delivered += answer.value(); });
        worker.start([&returned](const Progress&) -> Result<int> {
            returned.release();
            return 1;
        });
        returned.acquire();
        QThread::msleep(5); // it is posted, and the window has not come to it
        worker.start([](const Progress&) -> Result<int> { return 2; });
        QTRY_VERIFY(!worker.running());
        QCOMPARE(delivered, QList<int>{2});
    }

    void itsEndWaitsAndNothingIsDeliveredAfterIt()
    {
        bool delivered = false, finished = false;
        {
            QSemaphore begun;
            Worker<int> worker([&delivered](const Result<int>&) { delivered = true; });
            worker.start([&begun, &finished](const Progress& progress) -> Result<int> {
                begun.release();
                while (progress(0.0))
                    QThread::msleep(1);
                finished = true;
                return 1;
            });
            begun.acquire();
        }
        QVERIFY(finished);
        QTest::qWait(20);
        QVERIFY(!delivered);
    }

    void aDeliveryMayStartTheNextOrEndTheWorker()
    {
        int answers = 0;
        std::unique_ptr<Worker<int>> worker;
        const Worker<int>::Work work = [](const Progress&) -> Result<int> { return 1; };
        worker = std::make_unique<Worker<int>>([&](const Result<int>&) {
            if (++answers < 3)
                worker->start(work);
            else
                worker.reset();
        });
        worker->start(work);
        QTRY_VERIFY(!worker);
        QCOMPARE(answers, 3);
    }
};

} // namespace lubberline::ui

QTEST_GUILESS_MAIN(lubberline::ui::WorkerTest)
#include "WorkerTest.moc"
