package main

import "fmt"

func main() { c := make(chan int); go func() { c <- 6 * 7 }(); fmt.Println("hello", <-c) }
