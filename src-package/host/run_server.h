// SPDX-License-Identifier: GPL-2.0-or-later
// Runs decks one after the other, each in a copy of this process. The program is already loaded and
// MPI has been started, which takes longer than a short run. Every run is a process of its own, so
// an error in one run cannot affect another.
//
// Standard input is a socket that keeps messages apart (SOCK_SEQPACKET). A request consists of the
// words of a command line, separated by null characters, and of file descriptors: first the output
// of the run, then others that it keeps open. The answers are pairs of numbers: {process, 0} at the
// start of a run, and {process, exit code} at its end, where a signal is a negative exit code.
#pragma once

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <string>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

class RunServer {
 public:
  // Answers requests until there are no more, and then returns false. In the process of a run, it
  // returns true and the words of its command line.
  bool next(std::vector<std::string> &words)
  {
    answer(getpid(), 0);    // ready
    for (;;) {
      std::vector<int> files;
      if (!receive(words, files)) return false;
      const pid_t run = fork();
      if (run == 0) {
        become_run(files);
        return true;
      }
      for (const int file : files) close(file);
      answer(run, 0);
      int status = 127 << 8;
      if (run > 0)
        while (waitpid(run, &status, 0) < 0 && errno == EINTR) {}
      answer(run, WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status));
    }
  }

 private:
  static constexpr int most_files = 8;

  static void answer(int process, int code)
  {
    const int pair[2] = {process, code};
    if (send(0, pair, sizeof pair, MSG_NOSIGNAL) < 0) _exit(1);    // nobody waits for the answer
  }

  static bool receive(std::vector<std::string> &words, std::vector<int> &files)
  {
    std::vector<char> text(1 << 18);
    alignas(cmsghdr) char control[CMSG_SPACE(most_files * sizeof(int))];
    iovec part = {text.data(), text.size()};
    msghdr message = {};
    message.msg_iov = &part;
    message.msg_iovlen = 1;
    message.msg_control = control;
    message.msg_controllen = sizeof control;
    ssize_t size;
    while ((size = recvmsg(0, &message, 0)) < 0 && errno == EINTR) {}
    if (size <= 0) return false;
    for (cmsghdr *c = CMSG_FIRSTHDR(&message); c; c = CMSG_NXTHDR(&message, c)) {
      if (c->cmsg_type != SCM_RIGHTS) continue;
      files.resize((c->cmsg_len - CMSG_LEN(0)) / sizeof(int));
      memcpy(files.data(), CMSG_DATA(c), files.size() * sizeof(int));
    }
    words.clear();
    for (ssize_t at = 0; at < size; at += static_cast<ssize_t>(words.back().size()) + 1)
      words.emplace_back(text.data() + at, strnlen(text.data() + at, size - at));
    return !files.empty();
  }

  static void become_run(const std::vector<int> &files)
  {
    setsid();
    const int nothing = open("/dev/null", O_RDONLY);
    dup2(nothing, 0);
    close(nothing);
    dup2(files[0], 1);
    dup2(files[0], 2);
    close(files[0]);
  }
};
