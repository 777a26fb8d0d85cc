#include "db/engine/Database.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSqlDatabase>
#include <QSqlError>
#include <QThread>
#include <QUrl>

#include <atomic>
#include <limits>

#include "core/base/PartialFile.h"
#include "db/engine/Changes.h"
#include "db/engine/Copy.h"
#include "db/engine/SqlError.h"
#include "db/engine/Statement.h"
#include "db/engine/Transaction.h"
#include "db/engine/WorkFolder.h"

namespace lubberline::db {

namespace {

const QString kInMemory = ":memory:";               // for tests; the commands never name it so
constexpr std::int64_t kApplicationId = 0x4C554242; // "LUBB", in the file's header

QString newConnectionName()
{
    static std::atomic<int> count{0};
    return QStringLiteral("lubberline-%1").arg(++count);
}

Result<void> checkFile(const QString& path, OpenMode mode)
{
    const QFileInfo file(path);
    const std::string name = path.toStdString();
    if (file.isDir())
        return Error{ErrorCode::Io, MARKED("db", "this is a folder; expected a database file"), name};
    if (file.exists() && !file.isFile())
        return Error{ErrorCode::Io, MARKED("db", "this is a pipe or a device; expected a database file"), name};
    if (file.exists() && file.size() == 0 && mode == OpenMode::ReadOnly)
        return Error{ErrorCode::Format, MARKED("db", "the file is empty; expected a Lubberline database"), name};
    if (file.exists())
        return {};
    if (mode == OpenMode::ReadOnly)
        return Error{ErrorCode::NotFound, MARKED("db", "there is no such database; expected an existing file"), name};
    const QFileInfo folder(file.absolutePath());
    if (!folder.isDir())
        return Error{ErrorCode::Io,
            {MARKED("db", "the folder %1 is not there; expected an existing one for the new database"), folder.filePath().toStdString()},
            name};
    if (!folder.isWritable())
        return Error{ErrorCode::Io,
            {MARKED("db", "the folder %1 may not be written; expected one that may"), folder.filePath().toStdString()}, name};
    return {};
}

/// SQLite writes its log beside the file, so the folder counts, too.
bool mayNotBeWritten(const QString& path)
{
    const QFileInfo file(path);
    return file.exists() && (!file.isWritable() || !QFileInfo(file.absolutePath()).isWritable());
}

/// SQLite does not wait by itself when two programs make the same new database: one turns on the log while the other wants to.
Result<void> turnOnLog(const Database& database)
{
    for (int attempt = 0;; ++attempt) {
        const auto done = execute(database, "PRAGMA journal_mode = WAL");
        if (done || done.error().code != ErrorCode::Locked || attempt == 20)
            return done;
        QThread::msleep(100);
    }
}

Result<void> configure(const Database& database)
{
    // 32 MiB of pages: a search through 100,000 swings reads each page once.
    for (const char* pragma : {"PRAGMA foreign_keys = ON", "PRAGMA synchronous = FULL", "PRAGMA cache_size = -32768"})
        if (const auto done = execute(database, pragma); !done)
            return done;
    return database.readOnly() ? execute(database, "PRAGMA query_only = ON") : turnOnLog(database);
}

/// Ours, or empty and so about to become ours.
Result<void> checkIdentity(Database& database, int newest)
{
    const auto moment = Transaction::beginReading(database); // another program may be making it just now
    if (!moment)
        return moment.error();
    const auto application = number(database, "PRAGMA application_id");
    if (!application)
        return application.error();
    const auto version = number(database, "PRAGMA user_version");
    if (!version)
        return version.error();
    const auto tables = number(database, "SELECT COUNT(*) FROM sqlite_master");
    if (!tables)
        return tables.error();
    const std::string file = database.path().toStdString();
    if (*tables == 0 && *application == 0 && *version == 0)
        return {};
    if (*application != kApplicationId)
        return Error{ErrorCode::Format, MARKED("db", "this SQLite file was not made by Lubberline; expected a fleet database"), file};
    if (*version > newest)
        return Error{ErrorCode::NewerSchema,
            {MARKED("db", "the database has schema %1, made by a newer Lubberline; this one knows schemas up to %2: update the program"),
                *version, newest},
            file};
    return {};
}

Result<void> apply(Database& database, const Migration& step)
{
    auto transaction = Transaction::begin(database);
    if (!transaction)
        return transaction.error();
    // Another program may have made the step while we waited for the lock.
    const auto version = number(database, "PRAGMA user_version");
    if (!version)
        return version.error();
    if (*version >= step.version)
        return {};
    Result<void> done;
    for (std::size_t i = 0; done && i < step.statements.size(); ++i)
        done = execute(database, step.statements[i]);
    if (done && step.work)
        done = step.work(database);
    if (!done) {
        Error error = done.error();
        error.message = {MARKED("db", "the step to schema %1 (%2) failed, nothing was changed: %3"), step.version,
            std::string(step.description), std::move(error.message)};
        return error;
    }
    for (const QString& pragma :
        {QStringLiteral("PRAGMA application_id = %1").arg(kApplicationId), QStringLiteral("PRAGMA user_version = %1").arg(step.version)})
        if (const auto marked = execute(database, pragma); !marked)
            return marked;
    return transaction->commit();
}

/// A new database is made whole or not at all: another first writer must not find it half-way, and take it for an old one.
Result<void> makeNew(Database& database, const std::vector<Migration>& steps)
{
    auto transaction = Transaction::begin(database);
    if (!transaction)
        return transaction.error();
    const auto version = number(database, "PRAGMA user_version");
    if (!version)
        return version.error();
    if (*version > 0)
        return {}; // it was faster
    for (const auto& step : steps)
        if (const auto done = apply(database, step); !done)
            return done;
    return transaction->commit();
}

Result<void> migrate(Database& database, const std::vector<Migration>& steps)
{
    if (database.fileSchema() == 0)
        return makeNew(database, steps);
    for (const auto& step : steps)
        if (step.version > database.fileSchema())
            if (const auto done = apply(database, step); !done)
                return done;
    return {};
}

/// "fleet.lubberline.schema-7.20261127T011500Z.backup", beside it.
QString placeForBackup(const Database& database)
{
    QString time = QString::fromStdString(database.clock().nowUtc());
    time.remove('-').remove(':');
    return QStringLiteral("%1.schema-%2.%3.backup").arg(database.path()).arg(database.fileSchema()).arg(time);
}

} // namespace

struct Database::State {
    QString path;
    QString file;                     ///< that is open: path, or a copy of it
    std::unique_ptr<WorkFolder> work; ///< of the copy
    int schema = 0;                   ///< of path, as it was found
    std::vector<Message> told;
    QString connection = newConnectionName();
    bool readOnly = false;    ///< we do not write
    bool isProtected = false; ///< we could not
    TransactionState transaction;
    Changes changes;
    Fault fault;
    Clock clock = machineClock();

    Result<void> connect(bool immutable);
    ~State();
};

/// `immutable`: SQLite is told that nobody changes the file, and makes no files beside it.
Result<void> Database::State::connect(bool immutable)
{
    QSqlDatabase handle = QSqlDatabase::database(connection, false);
    if (handle.isValid())
        handle.close();
    else
        handle = QSqlDatabase::addDatabase("QSQLITE", connection);
    // A reader may have to wait for a writer's commit; more than two seconds means that something holds the file.
    QString options = "QSQLITE_BUSY_TIMEOUT=2000";
    // Only where it must be: a connection that cannot write leaves the files of the log behind when it is the last one.
    if (isProtected)
        options += ";QSQLITE_OPEN_READONLY";
    if (immutable)
        options += ";QSQLITE_OPEN_URI";
    const QUrl url = QUrl::fromLocalFile(QFileInfo(file).absoluteFilePath());
    // The name of a file and nothing else: SQLite would take "file:…" for an address and ":…" for a place of its own.
    const QString name = file == kInMemory || file.startsWith('/') ? file : "./" + file;
    handle.setDatabaseName(immutable ? url.toString(QUrl::FullyEncoded) + "?immutable=1" : name);
    handle.setConnectOptions(options);
    if (!handle.open())
        return errorOf(handle.lastError(), path);
    return {};
}

Database::State::~State()
{
    { // all handles must be gone before the connection is removed
        QSqlDatabase handle = QSqlDatabase::database(connection, false);
        if (handle.isValid())
            handle.close();
    }
    QSqlDatabase::removeDatabase(connection);
}

Database::Database(std::unique_ptr<State> state) : m_state(std::move(state)) {}
std::vector<std::string> filesOf(const QString& path)
{
    std::vector<std::string> files;
    for (const char* ending : {"", "-wal", "-shm", "-journal"}) // sqlite.org/tempfiles.html
        files.push_back(path.toStdString() + ending);
    return files;
}

Database::Database(Database&&) noexcept = default;
Database& Database::operator=(Database&&) noexcept = default;
Database::~Database() = default;

QString Database::path() const { return m_state->path; }
bool Database::readOnly() const { return m_state->readOnly; }
const std::vector<Message>& Database::told() const { return m_state->told; }
int Database::fileSchema() const { return m_state->schema; }
bool Database::readAsCopy() const { return m_state->work != nullptr; }
QSqlDatabase Database::connection() const { return QSqlDatabase::database(m_state->connection, false); }
Result<void> Database::onlyRead()
{
    m_state->readOnly = true;
    return execute(*this, "PRAGMA query_only = ON");
}

Result<void> Database::setPatience(int milliseconds)
{
    return execute(*this, QStringLiteral("PRAGMA busy_timeout = %1").arg(milliseconds));
}

Changes& Database::changes() const { return m_state->changes; }
void Database::setFault(Fault fault) { m_state->fault = std::move(fault); }
const Fault& Database::fault() const { return m_state->fault; }
void Database::setClock(Clock clock) { m_state->clock = std::move(clock); }
const Clock& Database::clock() const { return m_state->clock; }
TransactionState& Database::transactionState() { return m_state->transaction; }

Result<void> Database::connectToOurs(int newest)
{
    auto known = m_state->connect(false);
    if (known)
        known = checkIdentity(*this, newest);
    if (known || !m_state->isProtected || (known.error().code != ErrorCode::Io && known.error().code != ErrorCode::ReadOnly))
        return known;
    // The log needs an index file beside the database. Where that cannot be made the file is read as one that nobody changes,
    // which is so unless somebody with more rights opens it at the same time. A log with contents, however, would be left out.
    if (QFileInfo(path() + "-wal").size() > 0)
        return Error{ErrorCode::Io,
            MARKED("db",
                "the database was not closed properly, and its folder may not be written; expected one that may, so that what was stored last can be recovered"),
            path().toStdString()};
    if (const auto connected = m_state->connect(true); !connected)
        return connected;
    return checkIdentity(*this, newest);
}

/// Connected, known to be ours, set up; its schema is whatever it is.
Result<void> Database::connectAndConfigure(int newest)
{
    // Nothing is written before the file is known to be ours.
    if (const auto connected = connectToOurs(newest); !connected)
        return connected.error();
    if (const auto configured = configure(*this); !configured)
        return configured.error();
    const auto version = number(*this, "PRAGMA user_version");
    if (!version)
        return version.error();
    m_state->schema = static_cast<int>(*version);
    return {};
}

Result<Database> Database::openAsItIs(const QString& path)
{
    if (const auto checked = checkFile(path, OpenMode::ReadOnly); !checked)
        return checked.error();
    Database database(stateFor(path, OpenMode::ReadOnly));
    if (const auto connected = database.connectAndConfigure(std::numeric_limits<int>::max()); !connected)
        return connected.error();
    return database;
}

std::unique_ptr<Database::State> Database::stateFor(const QString& path, OpenMode mode)
{
    const bool inMemory = path == kInMemory;
    auto state = std::make_unique<State>();
    state->path = state->file = path;
    state->isProtected = !inMemory && mayNotBeWritten(path);
    state->readOnly = !inMemory && (state->isProtected || mode == OpenMode::ReadOnly);
    return state;
}

/// What may not be changed is copied, and the copy brought up to date.
Result<Database> Database::openCopy(const QString& path, const Database& original, const std::vector<Migration>& steps)
{
    auto state = std::make_unique<State>();
    state->work = std::make_unique<WorkFolder>();
    state->path = path;
    state->file = state->work->filePath("copy.lubberline");
    const Error none{ErrorCode::ReadOnly,
        {MARKED("db",
             "the database has the old schema %1 and may only be read, and no copy could be made to bring up to date; expected room"
             " for one among the temporary files"),
            original.fileSchema()},
        path.toStdString()};
    if (!state->work->isValid() || !copyInto(original, state->file))
        return none;
    Database copy(std::move(state));
    if (const auto connected = copy.connectAndConfigure(steps.back().version); !connected)
        return connected.error();
    if (const auto migrated = migrate(copy, steps); !migrated)
        return migrated.error();
    if (const auto reading = copy.onlyRead(); !reading)
        return reading.error();
    copy.m_state->told.push_back(
        {MARKED("db", "the database has the old schema %1; it was read as a copy and stays as it is"), copy.fileSchema()});
    return copy;
}

/// A copy as it was, before anything is changed.
Result<void> Database::bringUpToDate(const std::vector<Migration>& steps)
{
    // Of what nothing was ever stored in (another program is making it just now) there is nothing to keep.
    const auto stored = fileSchema() == 0 ? Result<std::int64_t>(0) : number(*this, "SELECT COUNT(*) FROM audit_entry");
    if (!stored)
        return stored.error();
    const bool isNew = *stored == 0;
    const QString copy = placeForBackup(*this);
    if (!isNew)
        if (const auto made = copyTo(*this, copy); !made && made.error().code != ErrorCode::Conflict) { // another program made it just now
            Error error = made.error();
            error.message
                = {MARKED("db", "nothing was changed: before the database is brought up to date a copy is made, and it failed: %1"),
                    std::move(error.message)};
            return error;
        }
    if (const auto migrated = migrate(*this, steps); !migrated)
        return migrated;
    if (!isNew)
        m_state->told.push_back({MARKED("db", "the database was brought from schema %1 to %2; a copy as it was stands in %3"), fileSchema(),
            steps.back().version, copy.toStdString()});
    return {};
}

Result<Database> Database::open(const QString& path, OpenMode mode, const std::vector<Migration>& steps)
{
    const bool inMemory = path == kInMemory;
    if (!inMemory)
        if (const auto checked = checkFile(path, mode); !checked)
            return checked.error();
    Database database(stateFor(path, mode));
    if (const auto connected = database.connectAndConfigure(steps.back().version); !connected)
        return connected.error();
    if (!inMemory && !database.readOnly())
        removeLeftovers(QFileInfo(path).absolutePath().toStdString());
    if (database.fileSchema() >= steps.back().version)
        return database;
    if (database.readOnly())
        return openCopy(path, database, steps);
    if (const auto done = database.bringUpToDate(steps); !done)
        return done.error();
    return database;
}

} // namespace lubberline::db
