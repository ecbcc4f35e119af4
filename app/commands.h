// SPDX-License-Identifier: MIT
#pragma once

#include "app/console.h"
#include "app/exit_code.h"

namespace CLI {
class App;
}

// One function a command: it adds the command to the program and has `outcome` set when the command has run.

namespace bedmix {

struct CommandContext {
  Console& console;
  ExitCode& outcome;
};

void addRunCommand(CLI::App& program, CommandContext context);
void addReplayCommand(CLI::App& program, CommandContext context);
void addRenderCommand(CLI::App& program, CommandContext context);
void addSheetCommand(CLI::App& program, CommandContext context);
void addPlotCommand(CLI::App& program, CommandContext context);
void addReportCommand(CLI::App& program, CommandContext context);
void addExportCommand(CLI::App& program, CommandContext context);
void addRecoverCommand(CLI::App& program, CommandContext context);
void addViewCommand(CLI::App& program, CommandContext context);
void addAccuracyCommand(CLI::App& program, CommandContext context);
void addCheckCommand(CLI::App& program, CommandContext context);
void addScenesCommand(CLI::App& program, CommandContext context);
void addDoctorCommand(CLI::App& program, CommandContext context);
void addCompletionCommand(CLI::App& program, CommandContext context);

}  // namespace bedmix
