// Threads, exceptions and streams, for the test of pack.
#include <iostream>
#include <map>
#include <stdexcept>
#include <thread>
#include <vector>
thread_local int local = 7;
std::map<std::string, int> numbers = {{"one", 1}, {"two", 2}};
int main() {
    std::vector<int> results(6);
    std::vector<std::thread> threads;
    for (int i = 0; i < 6; ++i)
        threads.emplace_back([&results, i] {
            try {
                local += i;
                if (i & 1) throw std::runtime_error("odd");
                results[i] = local;
            } catch (const std::exception &) {
                results[i] = -local;
            }
        });
    for (auto &t : threads) t.join();
    for (int r : results) std::cout << r << ' ';
    std::cout << local << ' ' << numbers.at("two") << std::endl;
    try {
        numbers.at("three");
    } catch (const std::out_of_range &e) {
        std::cout << e.what() << '\n';
    }
    throw 1; // not caught: it ends by a signal
}
