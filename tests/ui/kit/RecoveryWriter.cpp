// Keeps what could not be stored, or puts it in, until it is killed (tests/db/KillAtCall.cpp), and says on standard output what is done.
//   recovery_writer DATABASE FILE keep      compass headings of the readings of swing 1, 100° + row; says each row that is kept
//   recovery_writer DATABASE FILE restore   puts all of them in; says how many
//   recovery_writer DATABASE FILE forget    takes them off the file; says 0

#include <cstdio>
#include <cstring>

#include <QCoreApplication>

#include "ui/kit/Recovery.h"

using namespace lubberline;

namespace {

void say(int number)
{
    std::printf("%d\n", number);
    std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv)
{
    const QCoreApplication application(argc, argv);
    if (argc != 4)
        return 2;
    const auto opened = db::openStores(QString::fromLocal8Bit(argv[1]), db::OpenMode::ReadWriteCreate);
    if (!opened)
        return 2;
    db::Stores& stores = **opened;
    const ui::Recovery recovery({QString::fromLocal8Bit(argv[2])});
    if (std::strcmp(argv[3], "restore") == 0) {
        say(recovery.restore(stores, recovery.entriesFor(stores)).done);
        return 0;
    }
    if (std::strcmp(argv[3], "forget") == 0) {
        recovery.forget(recovery.entriesFor(stores));
        say(0);
        return 0;
    }
    const auto record = stores.swings.record(SwingId{1});
    if (!record)
        return 2;
    for (int row = 0; row < static_cast<int>(record->swing.readings.size()); ++row) {
        const Reading& before = record->swing.readings[static_cast<std::size_t>(row)];
        Reading wanted = before;
        wanted.compass = CompassHeading::fromDegrees(100 + row);
        if (!recovery.keep(stores,
                {stores.location().toStdString(), record->swing.id, record->swing.record, record->aircraft.registration,
                    LostReading{row, wanted, before.id, before}}))
            return 2;
        say(row);
    }
    return 0;
}
