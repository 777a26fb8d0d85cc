#include "app/CommandLine.h"

int main(int argc, char** argv) { return lubberline::app::runCommandLine(argc, argv); }
