#include "app/CommandLine.h"

#include <exception>
#include <new>

#include "app/Console.h"

int main(int argc, char** argv)
{
    using namespace lubberline;
    try {
        return app::whenPrinted(app::runCommandLine(argc, argv));
    } catch (const std::bad_alloc&) {
        return app::fail({ErrorCode::Full, MARKED("app", "there is not enough memory for this; expected smaller input or more memory")});
    } catch (const std::exception& broken) { // of a library; ours are a Result
        return app::fail(
            {ErrorCode::Unsupported, {MARKED("app", "this was not foreseen (%1); please report it"), std::string(broken.what())}});
    }
}
