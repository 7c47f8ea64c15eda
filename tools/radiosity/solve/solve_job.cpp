#include "tools/radiosity/solve/solve_job.h"

#include "tools/common/whole_file.h"

namespace odraz::radiosity {

namespace {

SolveJob readJob(common::Arguments &words) {
    SolveJob job;
    while (const char *word = words.next()) {
        std::string w = word;
        if (w == "-o")
            job.out = words.value(w);
        else if (w == "--progress")
            job.progress = true;
        else if (w == "--keep-every")
            job.keepEvery = words.number(w, 0.01, 1e9);
        else if (w == "--keep-rows")
            job.keepRows = true;
        else if (w == "--relight")
            job.relight = words.value(w);
        else if (job.options.take(w, words))
            continue;
        else if (word[0] != '-' && job.model.empty())
            job.model = w;
        else
            words.refuse(w);
    }
    if (job.model.empty()) throw common::Refused("name a model: radiosity solve MODEL.obj -o OUT");
    if (job.out.empty()) throw common::Refused("name a file for the solution with -o OUT");
    job.options.finish();
    return job;
}

SolveJob readJob(std::vector<std::string> words) {
    std::vector<char *> pointers = {nullptr};
    for (std::string &word : words) pointers.push_back(word.data());
    common::Arguments given((int)pointers.size(), pointers.data(), "radiosity --help");
    return readJob(given);
}

} // namespace

SolveJob beginJob(common::Arguments &words, SolveState &state, std::string &resumed) {
    while (const char *word = words.next()) {
        if (std::string(word) != "--resume") {
            state.words.push_back(word);
            continue;
        }
        resumed = words.value(word);
        if (!state.words.empty() || words.next())
            throw common::Refused("--resume takes no other option: it continues with the original ones");
        state = SolveState::read(resumed);
        break;
    }
    SolveJob job = readJob(state.words);
    common::checkWritable(job.out);
    return job;
}

std::unique_ptr<KeptRows> findRows(SolveJob &job) {
    if (job.keepRows)
        throw common::Refused("--keep-rows and --relight do not go together: the rows are kept already");
    if (job.out == job.relight)
        throw common::Refused("-o names the solution whose rows are used: give the new one another name");
    std::string file = rowsFile(job.relight);
    uint64_t solution = sumOfSolution(job.relight);
    auto kept = std::make_unique<KeptRows>(file);
    if (kept->solution != solution)
        throw common::Refused(file + ": belongs to another solution than " + job.relight +
                              " is now: solve with --keep-rows again");
    if (kept->model != sumOfFile(job.model))
        throw common::Refused(file + ": belongs to another model than " + job.model +
                              " is now: solve it again");
    job.options.follow(readJob(kept->words).options, file);
    if (kept->sky != sumOf(job.options.settings.surroundings.sky))
        throw common::Refused(
            file + ": belongs to another picture of the sky than there is now: solve the model again");
    return kept;
}

} // namespace odraz::radiosity
