#include "tools/radiosity/solve/solve_job.h"

#include "tools/common/whole_file.h"

namespace odraz::radiosity {

SolveJob::SolveJob(std::vector<std::string> words) : line("radiosity solve", std::move(words)) {
    line.about("Computes the light in a model and writes it to OUT, a solution for the other commands.\n"
               "Ctrl-C stops early: it writes the light found so far, and OUT.state.");
    line.argument("MODEL", model,
                  "a Wavefront OBJ or glTF. Polygons are lit on the side from which their points run "
                  "counter-clockwise. Materials reflect light (Kd, map_Kd) and emit it (Ke, map_Ke)",
                  false);
    line.option("-o", "OUT", out, "the file of the solution");
    line.option("--resume", "OUT.state", resume,
                "continue a stopped solution with its options, to the same bytes; takes no other option");
    line.option("--keep-every", "S", keepEvery, {0.01, 1e9}, "write OUT.state every S seconds");
    line.flag("--keep-rows", keepRows, "keep the form factors in OUT.rows, for --relight");
    line.option("--relight", "SOLUTION", relight,
                "solve for other materials with the form factors in SOLUTION.rows and with its options");
    options.addTo(line, SolveOptions::For::kSolve);
    line.parse();
    if (!resume.empty()) return;
    if (model.empty()) throw common::Refused("name a model: radiosity solve MODEL.obj -o OUT");
    if (out.empty()) throw common::Refused("name a file for the solution with -o OUT");
    options.finish(line);
}

static void findRows(SolveJob &job) {
    if (job.keepRows)
        throw common::Refused("--keep-rows and --relight do not go together: the rows are kept already");
    if (job.out == job.relight)
        throw common::Refused("-o names the solution whose rows are used: give the new one another name");
    std::string file = rowsFile(job.relight);
    uint64_t solution = sumOfSolution(job.relight);
    job.kept = std::make_unique<Kept>(file, Kept::Kind::kRows);
    const Kept &kept = *job.kept;
    if (kept.solution != solution)
        throw common::Refused(file + ": belongs to another solution, or " + job.relight +
                              " has changed: solve with --keep-rows again");
    if (kept.model != sumOfFile(job.model, kept.names.parts))
        throw common::Refused(file + ": belongs to another model, or " + job.model +
                              " has changed: solve it again");
    SolveJob with(kept.words);
    job.options.follow(job.line, with.options, with.line, file);
    if (kept.sky != sumOf(job.options.settings.surroundings.sky))
        throw common::Refused(file + ": the picture of the sky has changed: solve the model again");
}

std::unique_ptr<SolveJob> readJob(const std::vector<std::string> &words) {
    auto job = std::make_unique<SolveJob>(words);
    if (std::string state = job->resume; !state.empty()) {
        if (job->line.given().size() > 1 || !job->model.empty())
            throw common::Refused("--resume takes no other option: it continues with the original ones");
        auto kept = std::make_unique<Kept>(state, Kept::Kind::kState);
        job = std::make_unique<SolveJob>(kept->words);
        job->resume = state, job->kept = std::move(kept);
    }
    common::checkWritable(job->out);
    if (!job->relight.empty()) findRows(*job);
    return job;
}

} // namespace odraz::radiosity
