// deny PROGRAM...: runs the program, but the kernel refuses the system call CALL (EPERM).
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>
int main(int count, char **words) {
    struct sock_filter lines[] = {BPF_STMT(BPF_LD | BPF_W | BPF_ABS, 0), // the call's number
                                  BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, CALL, 0, 1),
                                  BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | 1),
                                  BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW)};
    struct sock_fprog all = {4, lines};
    return count < 2 || prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) ||
           prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &all) || execv(words[1], words + 1);
}
